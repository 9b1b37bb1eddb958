using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>A user name: 1 to 64 printable characters, compared without regard to case.</summary>
internal static class UserName
{
    /// <summary>The longest name, in UTF-16 units.</summary>
    public const int MostCharacters = 64;

    private const string OfSystem = "os:";

    // Names that the audit trail uses for acts without a person.
    private static readonly string[] Taken = ["cell", "console", "unknown"];

    /// <summary>The form in which names are compared.</summary>
    public static string Key(string name) => name.ToUpperInvariant();

    /// <summary>The key of a typed name. It may be a password typed in the wrong field, so it must not be stored as is.</summary>
    public static string Hash(string name) => ContentHash.Sha256OfText(Key(name));

    /// <summary>Rejects an invalid name.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.BadUserName"/>.</exception>
    public static void Demand(string name)
    {
        if (Problem(name) is { } problem)
        {
            throw new PeopleException(
                PeopleError.BadUserName,
                $"The name of a user {problem}. Expected 1 to {MostCharacters} printable characters, such as anna or \"Anna Weber\".");
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

        return Taken.Contains(Key(name), StringComparer.OrdinalIgnoreCase)
            ? $"is {name}, which the audit trail needs for what nobody did in person"
            : null;
    }

    // Unusual spaces, direction marks and separate accents make two names look alike.
    private static bool IsUnprintable(char c) => c != ' ' && char.GetUnicodeCategory(c) is
        UnicodeCategory.Control
            or UnicodeCategory.Format
            or UnicodeCategory.OtherNotAssigned
            or UnicodeCategory.PrivateUse
            or UnicodeCategory.LineSeparator
            or UnicodeCategory.ParagraphSeparator
        or UnicodeCategory.SpaceSeparator
            or UnicodeCategory.NonSpacingMark
            or UnicodeCategory.SpacingCombiningMark
            or UnicodeCategory.EnclosingMark;
}
