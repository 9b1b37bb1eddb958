using System.Buffers;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary>Text for people: headings, sentences and tables, in color if the terminal supports it.</summary>
internal sealed class Page(TextWriter writer, bool hasColor)
{
    private const string Bold = "\u001b[1m";
    private const string Red = "\u001b[31m";
    private const string Yellow = "\u001b[33m";
    private const string Green = "\u001b[32m";
    private const string Plain = "\u001b[0m";
    private static readonly SearchValues<char> OfNumbers = SearchValues.Create("0123456789+-.eE ");

    /// <summary>Writes a highlighted line.</summary>
    public void Heading(string text) => Line(hasColor ? Bold + text + Plain : text);

    /// <summary>Writes the line that says whether a result may be used: green if so, red if not, in no color if nobody has set a limit to
    /// judge it by.</summary>
    public void Verdict(string text, bool? isGood) => Line(
        hasColor ? Bold + isGood switch { true => Green, false => Red, null => "" } + text + Plain : text);

    /// <summary>Writes a warning.</summary>
    public void Warning(string text) => Line((hasColor ? Bold + Yellow + "Warning:" + Plain : "Warning:") + " " + text);

    /// <summary>Writes what is wrong.</summary>
    public void Error(string text) => Line(hasColor ? Red + text + Plain : text);

    /// <summary>Marks a changed word: in color if the terminal supports it, else with braces, which blocks contain only in
    /// comments.</summary>
    /// <param name="text">The word.</param>
    /// <param name="isOld">True for the old word, false for the new one.</param>
    /// <returns>What to print, and how many characters wider than the word it appears.</returns>
    public (string Text, int Extra) Marked(string text, bool isOld) =>
        hasColor ? ((isOld ? Red : Green) + text + Plain, 0) : ("{" + text + "}", 2);

    /// <summary>Writes a line.</summary>
    public void Line(string text = "")
    {
        writer.Write(text);
        writer.Write('\n');
    }

    /// <summary>Writes a text that contains its own line ends.</summary>
    public void Text(ReadOnlySpan<char> text) => writer.Write(text);

    /// <summary>Writes a table: each column as wide as its widest cell, columns two spaces apart, numbers right-aligned, text
    /// left-aligned.</summary>
    /// <param name="headings">One heading per column.</param>
    /// <param name="rows">Rows with as many cells as there are headings.</param>
    public void Table(IReadOnlyList<string> headings, IEnumerable<IReadOnlyList<string>> rows)
    {
        IReadOnlyList<string>[] body = [.. rows.Select(r => r.Select(PrintedText.OneLine).ToArray())];
        var widths = headings.Select((h, i) => Math.Max(h.Length, body.Length == 0 ? 0 : body.Max(r => r[i].Length))).ToArray();
        var isNumeric = headings.Select((_, i) => body.Length > 0 && body.All(r => r[i].Length == 0 || IsNumber(r[i]))).ToArray();
        Heading(Row(headings));
        foreach (var row in body)
        {
            Line(Row(row));
        }

        string Row(IReadOnlyList<string> cells) =>
            string.Join("  ", cells.Select((c, i) => isNumeric[i] ? c.PadLeft(widths[i]) : c.PadRight(widths[i]))).TrimEnd();
    }

    /// <summary>Writes names and their values in two columns.</summary>
    public void Facts(IReadOnlyList<(string Name, string Value)> facts)
    {
        var width = 0;
        foreach (var (name, _) in facts)
        {
            width = Math.Max(width, name.Length);
        }

        foreach (var (name, value) in facts)
        {
            Line(name.PadRight(width) + "  " + PrintedText.OneLine(value));
        }
    }

    private static bool IsNumber(string text) => !text.AsSpan().ContainsAnyExcept(OfNumbers);
}
