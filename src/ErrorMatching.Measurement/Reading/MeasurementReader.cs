using System.Security.Cryptography;

namespace ErrorMatching.Measurement;

/// <summary>Reads result files of gauges into labelled points. Nothing is guessed: what does not follow the format is an error that names its place.</summary>
public static class MeasurementReader
{
    /// <summary>Reads a file.</summary>
    /// <param name="path">The file, named in errors as it is given here.</param>
    /// <param name="format">How it is written.</param>
    /// <exception cref="MeasurementException">The file cannot be opened, or anything in it does not follow the format.</exception>
    public static MeasurementFile Read(string path, MeasurementFormat format) => Read(FileBytes.Read(path, format.MaxBytes), path, format);

    /// <summary>Reads the bytes of a file.</summary>
    /// <param name="bytes">The bytes.</param>
    /// <param name="fileName">The name of the file in errors and in rules about its source.</param>
    /// <param name="format">How it is written.</param>
    /// <exception cref="MeasurementException">Anything in it does not follow the format.</exception>
    public static MeasurementFile Read(ReadOnlyMemory<byte> bytes, string fileName, MeasurementFormat format)
    {
        FileBytes.ThrowIfTooLarge(fileName, bytes.Length, format.MaxBytes);
        var text = SourceText.Decode(bytes.Span, fileName, format.Encoding, format.Delimiter);
        var table = Table.Read(text, fileName, format.Layout);
        var (points, nominals, labels) = format.Columns.Read(table, format);
        return points.Count > 0
            ? new(Convert.ToHexStringLower(SHA256.HashData(bytes.Span)), format.Unit, table, labels, points, nominals)
            : throw labels.Fail(MeasurementError.NoPoints, "a table without points", "at least one point: export the measurement again");
    }
}
