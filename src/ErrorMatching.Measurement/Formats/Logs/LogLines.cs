namespace ErrorMatching.Measurement;

/// <summary>The lines of a control's log, without blank lines, spaces around them and the codes that start and stop a serial
/// line.</summary>
internal static class LogLines
{
    /// <summary>The line that POPEN and PCLOS print before and behind a log.</summary>
    public const string Bracket = "%";

    private const int LongestLine = 1_000;

    // DC1 to DC4, which controls send around what they print.
    private const string DeviceControls = "\u0011\u0012\u0013\u0014";

    /// <summary>The lines of a file.</summary>
    /// <exception cref="Refusals.InputException">It is no text, or a line is longer than any of a log.</exception>
    public static IEnumerable<TextLine> Of(MeasurementBytes source, MeasurementFormat format)
    {
        var text = SourceText.DecodeOwn(source.Bytes.Span, source.File, format.Encoding, DeviceControls);
        foreach (var line in TextLine.Of(text, source.File))
        {
            if (line.Text.Length > LongestLine)
            {
                throw line.Fail(
                    MeasurementError.BadStructure,
                    $"a line of more than {LongestLine} characters",
                    "the log of a control: is this the right file?");
            }

            if (Bare(line.Text) is { Length: > 0 } bare)
            {
                yield return line with { Text = bare };
            }
        }
    }

    /// <summary>The lines of the beginning of a file. The last one may be cut off.</summary>
    public static IEnumerable<string> OfHead(string head)
    {
        var at = 0;
        while (at < head.Length)
        {
            var end = LineBreaks.NextLine(head, at);
            if (Bare(head[at..end]) is { Length: > 0 } bare)
            {
                yield return bare;
            }

            at = end;
        }
    }

    /// <summary>True if the last line of a file has no end: the file may be cut off within a number.</summary>
    public static bool EndsWithinLine(MeasurementBytes source) => source.Bytes.Span is [.., not ((byte)'\n' or (byte)'\r' or 0)];

    private static string Bare(string line) => line.Trim().Trim('\u0011', '\u0012', '\u0013', '\u0014').Trim();
}
