using System.Globalization;
using System.Text;

namespace ErrorMatching.Measurement;

/// <summary>An unusable measurement, format or rule, with its location, the finding and the expectation.</summary>
public sealed class MeasurementException : Exception
{
    /// <summary>Creates an exception about a file or its description.</summary>
    /// <param name="code">One of the codes of <see cref="MeasurementError"/>.</param>
    /// <param name="found">The finding, as the middle of a sentence.</param>
    /// <param name="expected">The expectation or remedy, as the end of a sentence without a period.</param>
    /// <param name="file">The file name, as given by the caller; null if no file is concerned.</param>
    /// <param name="line">Line of the file or of the description, from 1.</param>
    /// <param name="column">Cell of the line, from 1, as in a spreadsheet; in a description, the character.</param>
    /// <param name="path">Path in the JSON description of a format, such as <c>$.columns.x</c>.</param>
    /// <param name="cause">The underlying error of the operating system or a parser.</param>
    public MeasurementException(
        string code,
        string found,
        string expected,
        string? file = null,
        int? line = null,
        int? column = null,
        string? path = null,
        Exception? cause = null)
        : base(Compose(found, expected, file, line, column, path), cause)
    {
        (Code, Found, Expected) = (code, found, expected);
        (File, Line, Column, Path) = (file, line, column, path);
    }

    /// <summary>One of the codes of <see cref="MeasurementError"/>.</summary>
    public string Code { get; }

    /// <summary>The file name, as given by the caller; null if no file is concerned.</summary>
    public string? File { get; }

    /// <summary>Line of the file or of the description, from 1; null if no line is concerned.</summary>
    public int? Line { get; }

    /// <summary>Cell of the line, from 1, as in a spreadsheet; in a description, the character. Null if no line is concerned.</summary>
    public int? Column { get; }

    /// <summary>Path in the JSON description of a format, such as <c>$.columns.x</c>; null for errors in measured data.</summary>
    public string? Path { get; }

    /// <summary>The finding.</summary>
    public string Found { get; }

    /// <summary>The expectation or remedy.</summary>
    public string Expected { get; }

    /// <summary>The finding and expectation in one sentence without the location, for callers that print the location themselves.</summary>
    public string Problem => Sentence(Found, Expected);

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

    private static string Compose(string found, string expected, string? file, int? line, int? column, string? path)
    {
        var place = new StringBuilder(file ?? path);
        Append(line is null ? null : string.Create(CultureInfo.InvariantCulture, $"line {line}"));
        Append(column is null ? null : string.Create(CultureInfo.InvariantCulture, $"column {column}"));
        Append(file is null ? null : path);
        return place.Length == 0 ? Sentence(found, expected) : $"{place}: {Sentence(found, expected)}";

        void Append(string? part) => place.Append(part is null || place.Length == 0 ? "" : ", ").Append(part);
    }

    private static string Sentence(string found, string expected) => $"found {found}; expected {expected}.";
}
