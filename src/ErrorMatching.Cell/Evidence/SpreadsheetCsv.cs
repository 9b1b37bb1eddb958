using System.Buffers;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>CSV by RFC 4180 that no spreadsheet executes. Text that starts like a formula gets a leading apostrophe, which marks it as text
/// in spreadsheets. Sources: OWASP, CSV Injection; OWASP ASVS 5.0, 1.2.10.</summary>
/// <remarks>A spreadsheet with another separator setting splits even a quoted cell, so a formula may start inside it. Therefore the text
/// after a semicolon, tab, bar or line end counts as a start too, regardless of spaces and quotes in between.</remarks>
internal static class SpreadsheetCsv
{
    // Half-width and full-width; some programs convert the latter to the former.
    private static readonly SearchValues<char> Executed = SearchValues.Create("=+-@\u0000\uff1d\uff0b\uff0d\uff20\u2212");

    /// <summary>Writes a row.</summary>
    public static void Write(TextWriter writer, params IReadOnlyList<string> cells)
    {
        for (var i = 0; i < cells.Count; i++)
        {
            writer.Write(i == 0 ? "\"" : ",\"");
            writer.Write(Defused(cells[i]).Replace("\"", "\"\"", StringComparison.Ordinal));
            writer.Write('"');
        }

        writer.Write("\r\n");
    }

    /// <summary>The text with an apostrophe before everything that a spreadsheet might execute.</summary>
    public static string Defused(string text)
    {
        var safe = new StringBuilder(text.Length + 4);
        var start = true;
        foreach (var c in text)
        {
            if (start && (Executed.Contains(c) || c is '\t' or '\r'))
            {
                safe.Append('\'');
            }

            safe.Append(c);
            start = IsSeparator(c) || (start && IsPassedOver(c));
        }

        return safe.ToString();
    }

    private static bool IsSeparator(char c) =>
        c is ';' or '\t' or '|' or '\r' or '\n' or '\v' or '\f' or '\u0085' or '\u2028' or '\u2029' or '\uff1b';

    private static bool IsPassedOver(char c) =>
        char.IsWhiteSpace(c)
            || c is '"' or '\u201c' or '\u201d' or '\uff02'
            || char.GetUnicodeCategory(c) is System.Globalization.UnicodeCategory.Format or System.Globalization.UnicodeCategory.Control;
}
