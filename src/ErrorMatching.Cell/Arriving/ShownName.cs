using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Names of files as databases keep them and screens show them.</summary>
internal static class ShownName
{
    /// <summary>The name with a replacement character for everything that is no visible character or would change how others look: line breaks, escapes, marks of direction, halves of characters.</summary>
    public static string Of(string name)
    {
        var shown = new StringBuilder(name.Length);
        foreach (var rune in name.EnumerateRunes())
        {
            shown.Append(IsVisible(rune) ? rune.ToString() : "\uFFFD");
        }

        return shown.ToString();
    }

    private static bool IsVisible(Rune rune) => Rune.GetUnicodeCategory(rune) is not (UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.LineSeparator
        or UnicodeCategory.ParagraphSeparator or UnicodeCategory.Surrogate or UnicodeCategory.PrivateUse or UnicodeCategory.OtherNotAssigned);
}
