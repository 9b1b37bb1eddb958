using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Reads result files of gauges into labeled points. Nothing is guessed: any deviation from the format is an error with its
/// location.</summary>
public static class MeasurementReader
{
    /// <summary>Reads a file.</summary>
    /// <param name="path">The file, as named in errors. With values (<c>.dfx</c>), their description (<c>.dfd</c>) is read, too.</param>
    /// <param name="format">The format of the file.</param>
    /// <exception cref="InputException">The file cannot be opened, or its content violates the format.</exception>
    public static MeasurementFile Read(string path, MeasurementFormat format)
    {
        ArgumentNullException.ThrowIfNull(format);
        return Read(MeasurementBytes.Read(path, format.MaxBytes), format);
    }

    /// <summary>Reads a file from its bytes.</summary>
    /// <param name="bytes">The bytes.</param>
    /// <param name="fileName">The file name in errors and source rules.</param>
    /// <param name="format">The format of the file.</param>
    /// <exception cref="InputException">The content violates the format.</exception>
    public static MeasurementFile Read(ReadOnlyMemory<byte> bytes, string fileName, MeasurementFormat format) =>
        Read(new MeasurementBytes(fileName, bytes), format);

    /// <summary>Reads a measurement from its bytes.</summary>
    /// <param name="source">The bytes.</param>
    /// <param name="format">The format of tables. A file that shows another format itself (QIF, AQDEF, DMIS, tables of CALYPSO and
    /// PC-DMIS, logs of controls) is read as that, unless the description of the format names columns or a line.</param>
    /// <exception cref="InputException">The content violates the format.</exception>
    public static MeasurementFile Read(MeasurementBytes source, MeasurementFormat format)
    {
        ArgumentNullException.ThrowIfNull(source);
        ArgumentNullException.ThrowIfNull(format);
        FileBytes.ThrowIfTooLarge(source.File, source.Bytes.Length, format.MaxBytes);
        var own = format.Origin == FormatOrigin.Described ? null : SelfDescribingFormat.Of(source);
        var content = own?.Read(source, format) ?? format.Line?.Read(source, format) ?? ReadTable(source, format);
        return content switch
        {
            { Points.Count: > 0 } => new(source, content),
            { Incomplete: [var (label, axis, place), ..] } => throw place.Fail(
                MeasurementError.MissingCoordinate,
                $"the point {MeasurementRefusal.Quote(label)} without {axis}",
                "X and Y of each point: measure and export them"),
            _ => throw content.Labels.Fail(
                MeasurementError.NoPoints,
                own is null ? "a table without points" : "a file without points",
                "at least one point: export the measurement again"),
        };
    }

    private static MeasuredContent ReadTable(MeasurementBytes source, MeasurementFormat format)
    {
        var text = SourceText.Decode(source.Bytes.Span, source.File, format.Encoding, format.Delimiter);
        format = format.Origin == FormatOrigin.Recognized ? TableRecognition.FormatOf(text, format) : format;
        if (format.Delimiter == ' ')
        {
            (text, format) = (Blanks.ToTabs(text), format with { Delimiter = '\t' });
        }

        var table = Table.Read(text, source.File, format.Layout);
        var (points, nominals, labels) = format.Columns.Read(table, format);
        return new(format.Unit, points, nominals, labels) { Fields = table.Fields, Texts = table.TextsOf };
    }
}
