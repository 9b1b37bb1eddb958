using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Valid names of saved jobs: valid folder names on every system that do not lead elsewhere.</summary>
internal static class SavedJobName
{
    private const int Longest = 64;
    private const string Forbidden = "/\\:*?\"<>|";

    /// <summary>Why a folder cannot have this name, or null.</summary>
    public static string? Defect(string name) =>
        name.Length is 0 or > Longest ? $"it has 1 to {Longest} characters"
        : name.EnumerateRunes().Any(r => Forbidden.Contains(r.ToString(), StringComparison.Ordinal) || IsUnseen(r))
            ? $"it has none of {string.Join(' ', Forbidden.ToCharArray())}, and nothing that is not seen"
        : name[0] is '.' or ' ' || name[^1] is '.' or ' ' ? "it neither begins nor ends with a dot or a space"
        : ProgramNames.IsReserved(name) ? "Windows keeps it for a device"
        : null;

    // A lone surrogate is read as the replacement character.
    private static bool IsUnseen(Rune rune) => rune == Rune.ReplacementChar
        || Rune.GetUnicodeCategory(rune) is UnicodeCategory.Control or UnicodeCategory.Format
        or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator or UnicodeCategory.PrivateUse;
}
