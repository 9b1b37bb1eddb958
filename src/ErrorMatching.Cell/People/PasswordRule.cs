using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Which passwords users may have: a minimum length, and not the first guesses. No composition rules and no expiry. Source: NIST
/// SP 800-63B (2017 with updates), 5.1.1.2, with a minimum of 8; 12 here, because the password is the only factor.</summary>
internal static class PasswordRule
{
    /// <summary>The minimum length, in UTF-16 units.</summary>
    public const int LeastCharacters = 12;

    /// <summary>The maximum length, in UTF-16 units: more than NIST's 64, yet too short for an attacker to cause much work.</summary>
    public const int MostCharacters = 256;

    // The most common passwords, without surrounding digits and signs and with the usual substitutions undone.
    private static readonly HashSet<string> Common =
    [
        "", "password", "passwort", "passphrase", "kennwort", "secret", "geheim", "letmein", "welcome", "willkommen", "changeme", "default",
        "iloveyou", "trustno", "monkey", "dragon", "master", "sunshine", "princess", "football",
        "baseball", "superman", "starwars", "whatever", "computer", "internet", "abc", "abcd", "abcdef", "abcdefgh", "abcdefghijkl",
        "abcdefghijklm", "qwe", "qwer", "qwert", "qwertz", "qwerty", "qwertyuiop", "qwertzuiop",
        "qwertyuiopasdf", "qwertzuiopasdf", "asdf", "asdfgh", "asdfghjkl", "zxcvbnm", "yxcvbnm", "qazwsx", "qazwsxedc", "qweasdzxc",
        "azerty", "azertyuiop", "admin", "administrator", "root", "user", "guest", "test", "testing",
        "login", "service", "operator", "setter", "machine", "maschine", "fanuc", "siemens", "heidenhain", "sinumerik", "haas", "mazak",
        "error", "matching", "errormatching", "errormatch",
    ];

    // Passwords that follow the calendar: a calendar word, a year and a sign are the first guess where passwords must be changed.
    private static readonly HashSet<string> Calendar =
    [
        "spring", "summer", "autumn", "fall", "winter", "january", "february", "march", "april", "may", "june", "july", "august",
        "september",
        "october", "november", "december", "monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday", "fruehling",
        "frühling", "sommer", "herbst", "januar", "februar", "märz", "maerz", "mai", "juni", "juli", "oktober", "dezember", "montag",
        "dienstag", "mittwoch", "donnerstag", "freitag", "samstag", "sonntag", "christmas", "weihnachten",
    ];

    // A machine can still guess two such words; three unrelated ones are far more combinations.
    private const int FewWords = 2;

    /// <summary>Rejects a password that is too short, too long, the name, or common.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.WeakPassword"/>.</exception>
    public static void Demand(string name, string password)
    {
        if (Problem(name, password) is { } problem)
        {
            throw new PeopleException(
                PeopleError.WeakPassword,
                $"This password {problem}. Take {LeastCharacters} characters or more that nobody guesses, such as four words that have "
                    + $"nothing to do with each other.");
        }
    }

    /// <summary>True if a text is one short piece again and again, or characters in their order.</summary>
    public static bool IsSimple(string text) => Period(text) * 2 <= text.Length || IsRun(text);

    private static string? Problem(string name, string password)
    {
        if (password.Length < LeastCharacters)
        {
            return string.Create(CultureInfo.InvariantCulture, $"has {password.Length} characters");
        }

        if (password.Length > MostCharacters)
        {
            return string.Create(CultureInfo.InvariantCulture, $"has {password.Length} characters, and at most {MostCharacters} are read");
        }

        if (password.Any(char.IsControl))
        {
            return "has a control character, which the next keyboard may not have";
        }

        if (Period(password) * 3 <= password.Length || IsRun(password))
        {
            return "is one short piece again and again, or characters in their order";
        }

        var letters = Letters(password);
        if (Letters(name) is { Length: > 0 } own && letters.Replace(own, "", StringComparison.Ordinal).Length == 0)
        {
            return "is the name, or the name with digits and signs around it";
        }

        if (Calendar.Contains(letters) || IsPattern(name, password))
        {
            return "is made of a season, a month, a day, the name or a common word, with a year or signs beside it";
        }

        return Common.Contains(letters) || Common.Contains(letters[..Period(letters)])
            ? "is one of those that are tried first, or one of them with digits and signs around it"
            : null;
    }

    // True if it has few words and all are the name or in a list, regardless of digits and signs between and around them.
    private static bool IsPattern(string name, string password)
    {
        var words = new HashSet<string>(StringComparer.Ordinal);
        var word = new StringBuilder();
        foreach (var c in password.ToLowerInvariant().Append(' '))
        {
            if (char.IsLetter(c))
            {
                word.Append(c);
            }
            else if (word.Length > 0)
            {
                words.Add(word.ToString());
                word.Clear();
            }
        }

        var own = Letters(name);
        return words.Count <= FewWords && words.All(w => w == own || Calendar.Contains(w) || Common.Contains(w)) && words.Count > 0;
    }

    // The length of the shortest unit that the text repeats; the last repetition may be incomplete.
    private static int Period(string text)
    {
        var period = 1;
        while (period < text.Length && !text.AsSpan(period).SequenceEqual(text.AsSpan(0, text.Length - period)))
        {
            period++;
        }

        return Math.Min(period, text.Length);
    }

    private static bool IsRun(string text) =>
        text.Zip(text.Skip(1)).Count(p => Math.Abs(p.Second - p.First) <= 1 || (p.First == '9' && p.Second == '0')) >= text.Length - 2;

    // Lowercase, with substitutions undone; digits and signs at the ends are removed.
    private static string Letters(string text)
    {
        var plain = text.ToLowerInvariant().AsSpan().Trim("0123456789 !\"#%&'()*+,-./:;<=>?[\\]^_`{|}~§€£");
        return string.Create(plain.Length, plain, (to, from) =>
        {
            for (var i = 0; i < from.Length; i++)
            {
                to[i] = from[i] switch
                {
                    '@' or '4' => 'a',
                    '0' => 'o',
                    '1' or '!' => 'i',
                    '3' => 'e',
                    '$' or '5' => 's',
                    '7' => 't',
                    var c => c
                };
            }
        });
    }
}
