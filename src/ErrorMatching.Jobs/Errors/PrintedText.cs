using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Makes external text, such as a file name, safe for a terminal or a readable log.</summary>
public static class PrintedText
{
    /// <summary>The text on one line. Line ends and tabs become spaces. Control characters and characters that change the writing
    /// direction become U+FFFD, so that a file name cannot add lines or hide the text next to it.</summary>
    public static string OneLine(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return text.Any(Steers) ? string.Concat(text.Select(c => !Steers(c) ? c : c is '\r' or '\n' or '\t' ? ' ' : '\uFFFD')) : text;
    }

    private static bool Steers(char c) =>
        char.GetUnicodeCategory(c) is UnicodeCategory.Control
            or UnicodeCategory.Format
            or UnicodeCategory.LineSeparator
            or UnicodeCategory.ParagraphSeparator;
}
