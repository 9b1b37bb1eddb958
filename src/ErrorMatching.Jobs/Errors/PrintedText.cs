using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Text from elsewhere, such as a file's name, as a terminal or a log for people may show it.</summary>
public static class PrintedText
{
    /// <summary>The text on one line: line ends and tabs become spaces, and what steers a terminal or turns the direction of writing becomes U+FFFD, so that no file's name writes lines of its own or hides what stands beside it.</summary>
    public static string OneLine(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return text.Any(Steers) ? string.Concat(text.Select(c => !Steers(c) ? c : c is '\r' or '\n' or '\t' ? ' ' : '\uFFFD')) : text;
    }

    private static bool Steers(char c) => char.GetUnicodeCategory(c) is UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator;
}
