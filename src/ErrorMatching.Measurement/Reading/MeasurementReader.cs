using System.Security.Cryptography;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Reads result files of gauges into labeled points. Nothing is guessed: any deviation from the format is an error with its
/// location.</summary>
public static class MeasurementReader
{
    /// <summary>Reads a file.</summary>
    /// <param name="path">The file, as named in errors.</param>
    /// <param name="format">The format of the file.</param>
    /// <exception cref="InputException">The file cannot be opened, or its content violates the format.</exception>
    public static MeasurementFile Read(string path, MeasurementFormat format) => Read(FileBytes.Read(path, format.MaxBytes), path, format);

    /// <summary>Reads a file from its bytes.</summary>
    /// <param name="bytes">The bytes.</param>
    /// <param name="fileName">The file name in errors and source rules.</param>
    /// <param name="format">The format of the file.</param>
    /// <exception cref="InputException">The content violates the format.</exception>
    public static MeasurementFile Read(ReadOnlyMemory<byte> bytes, string fileName, MeasurementFormat format)
    {
        FileBytes.ThrowIfTooLarge(fileName, bytes.Length, format.MaxBytes);
        var text = SourceText.Decode(bytes.Span, fileName, format.Encoding, format.Delimiter);
        format = format.Origin == FormatOrigin.Recognized ? TableRecognition.FormatOf(text, format) : format;
        var table = Table.Read(text, fileName, format.Layout);
        var (points, nominals, labels) = format.Columns.Read(table, format);
        return points.Count > 0
            ? new(Convert.ToHexStringLower(SHA256.HashData(bytes.Span)), format.Unit, table, labels, points, nominals)
            : throw labels.Fail(MeasurementError.NoPoints, "a table without points", "at least one point: export the measurement again");
    }
}
