using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Makes external text, such as a file name, safe for a terminal or a readable log.</summary>
public static class PrintedText
{
    /// <summary>The text on one line. Line ends, tabs and other control characters, and characters that change the writing direction,
    /// are shown as in JSON (<c>\t</c>, <c>\u001b</c>), so that a file name cannot add lines or hide the text next to it, and a reader
    /// sees what a file contains.</summary>
    public static string OneLine(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return text.Any(Steers) ? string.Concat(text.Select(c => Steers(c) ? Shown(c) : c.ToString())) : text;
    }

    private static string Shown(char c) => c switch
    {
        '\t' => "\\t",
        '\n' => "\\n",
        '\r' => "\\r",
        _ => string.Create(CultureInfo.InvariantCulture, $"\\u{(int)c:x4}"),
    };

    private static bool Steers(char c) =>
        char.GetUnicodeCategory(c) is UnicodeCategory.Control
            or UnicodeCategory.Format
            or UnicodeCategory.LineSeparator
            or UnicodeCategory.ParagraphSeparator;
}
