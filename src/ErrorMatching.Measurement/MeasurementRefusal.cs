using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Makes refusals about measurements, their formats and rules.</summary>
public static class MeasurementRefusal
{
    /// <summary>A measurement, format or rule that cannot be used.</summary>
    /// <param name="code">One of the codes of <see cref="MeasurementError"/>.</param>
    /// <param name="found">The finding, as the middle of a sentence.</param>
    /// <param name="expected">The expectation or remedy, as the end of a sentence without a period.</param>
    /// <param name="file">The file name, as given by the caller; null if no file is concerned.</param>
    /// <param name="line">Line of the file, from 1.</param>
    /// <param name="column">Cell of the line, from 1, as in a spreadsheet.</param>
    /// <param name="path">Path in the JSON description of a format, such as <c>$.columns.x</c>.</param>
    /// <param name="cause">The underlying error of the operating system or a parser.</param>
    public static InputException Of(
        string code,
        string found,
        string expected,
        string? file = null,
        int? line = null,
        int? column = null,
        string? path = null,
        Exception? cause = null) =>
        new(Refusal.Of(code, found, expected, new() { File = file, Line = line, Column = column, Path = path }), cause);

    /// <summary>Quotes a text of a file for display, without control characters and limited to a screen line.</summary>
    internal static string Quote(string text)
    {
        const int longest = 60;
        var shown = new StringBuilder("\"");
        foreach (var c in text.Length <= longest ? text : text[..longest])
        {
            _ = char.IsControl(c) || char.IsSurrogate(c)
                ? shown.Append(CultureInfo.InvariantCulture, $"\\u{(int)c:x4}")
                : shown.Append(c);
        }

        return shown.Append(text.Length <= longest ? "\"" : "...\"").ToString();
    }
}
