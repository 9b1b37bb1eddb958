using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>File names in the form that databases store and screens display.</summary>
internal static class ShownName
{
    /// <summary>Puts the replacement character in place of every character that is invisible or changes how others look: line breaks,
    /// escapes, direction marks, unpaired surrogates.</summary>
    public static string Of(string name)
    {
        var shown = new StringBuilder(name.Length);
        foreach (var rune in name.EnumerateRunes())
        {
            shown.Append(IsVisible(rune) ? rune.ToString() : "\uFFFD");
        }

        return shown.ToString();
    }

    private static bool IsVisible(Rune rune) =>
        Rune.GetUnicodeCategory(rune) is not (UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.LineSeparator
        or UnicodeCategory.ParagraphSeparator
            or UnicodeCategory.Surrogate
            or UnicodeCategory.PrivateUse
            or UnicodeCategory.OtherNotAssigned);
}
