using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>The rules and hashes of PINs and badges. Both are short or can be read by others, so their hashes need the key that codes rows:
/// the store alone is of no use to who guesses.</summary>
internal static class Credentials
{
    /// <summary>The fewest digits of a PIN. Source: NIST SP 800-63B (2017 with updates), 5.1.1.1: six, which may all be digits. With the
    /// lock-outs of passwords, somebody who guesses has some 30 attempts in a day.</summary>
    public const int LeastDigits = 6;

    /// <summary>The most digits of a PIN: fewer than a password has characters, so that nobody takes one for the other.</summary>
    public const int MostDigits = 8;

    /// <summary>The fewest characters of a badge's code.</summary>
    public const int LeastCharacters = 6;

    /// <summary>The most characters of a badge's code.</summary>
    public const int MostCharacters = 128;

    /// <summary>After this time without a badge of nobody, the earlier ones are forgotten.</summary>
    public static readonly TimeSpan BadgeMemory = TimeSpan.FromHours(2);

    /// <summary>The name under which failed badges are counted, whatever their codes: no user's name has this character.</summary>
    public const string AllBadges = "\u0001badges";

    /// <summary>True if a typed text has the form of a PIN. No password has.</summary>
    public static bool IsPin(string typed) => typed.Length is >= LeastDigits and <= MostDigits && typed.All(char.IsAsciiDigit);

    /// <summary>Rejects a PIN that is none, or that is guessed first.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.WeakPin"/>.</exception>
    public static void DemandPin(string pin)
    {
        var problem = !IsPin(pin) ? "is not made of digits alone, or has too few or too many"
            : PasswordRule.IsSimple(pin) ? "is digits in their order, or one short piece again and again"
            : null;
        if (problem is not null)
        {
            throw new PeopleException(
                PeopleError.WeakPin,
                string.Create(
                    CultureInfo.InvariantCulture, $"This PIN {problem}. Take {LeastDigits} to {MostDigits} digits that nobody guesses."));
        }
    }

    /// <summary>Rejects a code that is no badge's.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.BadBadge"/>.</exception>
    public static void DemandBadge(string code)
    {
        if (code.Length is < LeastCharacters or > MostCharacters || code.Any(char.IsControl) || code.Trim() != code)
        {
            throw new PeopleException(
                PeopleError.BadBadge,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"This code has {code.Length} characters, or some that no scanner sends. Expected {LeastCharacters} to "
                        + $"{MostCharacters} printable characters."));
        }
    }

    /// <summary>The hash of a badge's code: HMAC-SHA-256, in hex.</summary>
    public static string BadgeHash(byte[] key, string code) => Keyed(key, "badge", code);

    /// <summary>What is hashed of a PIN, as a password is: without the key, its million possibilities would be tried in a day.</summary>
    public static string PinSecret(byte[] key, string name, string pin) => Keyed(key, "pin", $"{UserName.Key(name)}\n{pin}");

    // What is hashed names its purpose, so that it is never the code of a row.
    private static string Keyed(byte[] key, string purpose, string text) =>
        Convert.ToHexStringLower(HMACSHA256.HashData(key, Encoding.UTF8.GetBytes($"errormatch {purpose} 1\n{text}")));
}
