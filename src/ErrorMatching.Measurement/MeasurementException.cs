using System.Globalization;
using System.Text;

namespace ErrorMatching.Measurement;

/// <summary>A measurement, its format or a rule about it that cannot be used: where, what was found, and what is expected instead.</summary>
public sealed class MeasurementException : Exception
{
    /// <summary>An error in a file or in the description of one.</summary>
    /// <param name="code">One of the words of <see cref="MeasurementError"/>.</param>
    /// <param name="found">What was found, as the middle of a sentence.</param>
    /// <param name="expected">What is expected or to be done, as the end of a sentence without its full stop.</param>
    /// <param name="file">The file as the caller named it; null if no file is concerned.</param>
    /// <param name="line">Line of the file, counted from 1.</param>
    /// <param name="column">Cell of the line, counted from 1 as a spreadsheet counts columns.</param>
    /// <param name="path">Place in the JSON description of a format, such as <c>$.columns.x</c>.</param>
    /// <param name="cause">The error of the operating system or of a parser that led here.</param>
    public MeasurementException(string code, string found, string expected, string? file = null, int? line = null, int? column = null, string? path = null, Exception? cause = null)
        : base(Compose(found, expected, file, line, column, path), cause)
    {
        (Code, Found, Expected) = (code, found, expected);
        (File, Line, Column, Path) = (file, line, column, path);
    }

    /// <summary>One of the words of <see cref="MeasurementError"/>.</summary>
    public string Code { get; }

    /// <summary>The file as the caller named it; null if no file is concerned.</summary>
    public string? File { get; }

    /// <summary>Line of the file, counted from 1; null if no line is concerned.</summary>
    public int? Line { get; }

    /// <summary>Cell of the line, counted from 1 as a spreadsheet counts columns; null if no line is concerned.</summary>
    public int? Column { get; }

    /// <summary>Place in the JSON description of a format, such as <c>$.columns.x</c>; null for errors in measured data.</summary>
    public string? Path { get; }

    /// <summary>What was found.</summary>
    public string Found { get; }

    /// <summary>What is expected, or what to do.</summary>
    public string Expected { get; }

    /// <summary>What was found and what is expected as one sentence without the place, for callers that print the place in their own form.</summary>
    public string Problem => Sentence(Found, Expected);

    /// <summary>A text of a file as it may be shown: in quotation marks, without control characters, and not longer than a line of a screen.</summary>
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
        var place = new StringBuilder(file);
        Append(line is null ? null : string.Create(CultureInfo.InvariantCulture, $"line {line}"));
        Append(column is null ? null : string.Create(CultureInfo.InvariantCulture, $"column {column}"));
        Append(path);
        return place.Length == 0 ? Sentence(found, expected) : $"{place}: {Sentence(found, expected)}";

        void Append(string? part) => place.Append(part is null || place.Length == 0 ? "" : ", ").Append(part);
    }

    private static string Sentence(string found, string expected) => $"found {found}; expected {expected}.";
}
