using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>A user's name: 1 to 64 printable characters, the same to us whether letters are large or small.</summary>
internal static class UserName
{
    /// <summary>The longest name, in UTF-16 units.</summary>
    public const int MostCharacters = 64;

    private const string OfSystem = "os:";

    // Who stands in the audit trail for what nobody did in person.
    private static readonly string[] Taken = ["cell", "console", "unknown"];

    /// <summary>The form in which names are compared.</summary>
    public static string Key(string name) => name.ToUpperInvariant();

    /// <summary>The key of a name that somebody typed, which may be a password in the wrong line and is not to be kept as it is.</summary>
    public static string Hash(string name) => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(Key(name))));

    /// <summary>Refuses what is no name.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.BadUserName"/>.</exception>
    public static void Demand(string name)
    {
        if (Problem(name) is { } problem)
        {
            throw new PeopleException(PeopleError.BadUserName, $"The name of a user {problem}. Expected 1 to {MostCharacters} printable characters, such as anna or \"Anna Weber\".");
        }
    }

    private static string? Problem(string name)
    {
        if (name.Length is 0 or > MostCharacters)
        {
            return name.Length == 0 ? "is empty" : string.Create(CultureInfo.InvariantCulture, $"has {name.Length} characters");
        }

        if (name.Any(char.IsSurrogate) || name.Any(IsUnprintable))
        {
            return "has a character that is not printed, or is a mark or picture of its own (an accent belongs into its letter)";
        }

        if (name.StartsWith(' ') || name.EndsWith(' ') || name.Contains("  ", StringComparison.Ordinal))
        {
            return "begins or ends with a space, or has two of them in a row";
        }

        if (name.StartsWith('-'))
        {
            return "begins with a hyphen, which the command line takes for an option";
        }

        if (name.StartsWith(OfSystem, StringComparison.OrdinalIgnoreCase))
        {
            return $"begins with {OfSystem}, which the audit trail needs for users of the operating system";
        }

        return Taken.Contains(Key(name), StringComparer.OrdinalIgnoreCase) ? $"is {name}, which the audit trail needs for what nobody did in person" : null;
    }

    // Spaces other than the usual one, direction marks and separate accents make two names look like one.
    private static bool IsUnprintable(char c) => c != ' ' && char.GetUnicodeCategory(c) is
        UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.OtherNotAssigned or UnicodeCategory.PrivateUse or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator
        or UnicodeCategory.SpaceSeparator or UnicodeCategory.NonSpacingMark or UnicodeCategory.SpacingCombiningMark or UnicodeCategory.EnclosingMark;
}
