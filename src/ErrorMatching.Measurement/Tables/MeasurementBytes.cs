using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>The bytes of one measurement: a file, or a file of values (<c>.dfx</c>) with the file that describes them
/// (<c>.dfd</c>).</summary>
public sealed class MeasurementBytes
{
    private readonly byte[] _both;

    /// <summary>The bytes of a measurement that is one file.</summary>
    /// <param name="file">The file name, for messages.</param>
    /// <param name="bytes">The bytes.</param>
    public MeasurementBytes(string file, ReadOnlyMemory<byte> bytes)
        : this(file, bytes, null)
    {
    }

    private MeasurementBytes(string file, ReadOnlyMemory<byte> bytes, MeasurementBytes? description)
    {
        (File, Bytes, Description) = (file, bytes, description);
        _both = description is null ? [] : [.. description.Bytes.Span, .. bytes.Span];
    }

    /// <summary>The file name, as given by the caller.</summary>
    public string File { get; }

    /// <summary>The bytes of the named file.</summary>
    public ReadOnlyMemory<byte> Bytes { get; }

    /// <summary>The file that describes the values; null if the measurement is one file.</summary>
    public MeasurementBytes? Description { get; }

    /// <summary>The files that were read.</summary>
    public IReadOnlyList<string> Files => Description is null ? [File] : [File, Description.File];

    /// <summary>SHA-256 of the bytes, the description's before those of the values, as 64 lowercase hexadecimal digits.</summary>
    public string Sha256 => ContentHash.Sha256(Description is null ? Bytes.Span : _both);

    /// <summary>Reads a measurement. With a file of values (<c>.dfx</c>), the file that describes them is read from the same folder: the
    /// same name with <c>.dfd</c>, no link.</summary>
    /// <param name="path">The file, as named in errors.</param>
    /// <param name="maxBytes">Maximum size of each file.</param>
    /// <exception cref="InputException">A file cannot be opened (<see cref="MeasurementError.FileUnreadable"/>) or is too large
    /// (<see cref="MeasurementError.FileTooLarge"/>).</exception>
    public static MeasurementBytes Read(string path, int maxBytes)
    {
        var bytes = FileBytes.Read(path, maxBytes);
        var description = DescriptionOf(path);
        return description is null
            ? new(path, bytes)
            : new(path, bytes, new(description, FileBytes.Read(description, maxBytes)));
    }

    /// <summary>True if the file has an extension, in any case.</summary>
    internal bool Has(string extension) => File.EndsWith(extension, StringComparison.OrdinalIgnoreCase);

    /// <summary>The names that the file may have that describes values; none if a file describes itself.</summary>
    /// <param name="file">Name or path of the file.</param>
    public static IReadOnlyList<string> DescriptionsOf(string file)
    {
        ArgumentNullException.ThrowIfNull(file);
        return file.EndsWith(".dfx", StringComparison.OrdinalIgnoreCase) ? [file[..^1] + 'd', file[..^1] + 'D'] : [];
    }

    /// <summary>True for the name of a file that only describes values.</summary>
    /// <param name="file">Name or path of the file.</param>
    public static bool IsDescription(string file)
    {
        ArgumentNullException.ThrowIfNull(file);
        return file.EndsWith(".dfd", StringComparison.OrdinalIgnoreCase);
    }

    /// <summary>Values behind their description, as one file that describes itself.</summary>
    /// <remarks>A mark of the encoding at the start of the values is left out, and a description that ends within a line gets its
    /// end.</remarks>
    /// <param name="description">The bytes of the description.</param>
    /// <param name="values">The bytes of the values.</param>
    public static byte[] Joined(ReadOnlySpan<byte> description, ReadOnlySpan<byte> values)
    {
        if (values.StartsWith("\uFEFF"u8))
        {
            values = values["\uFEFF"u8.Length..];
        }

        return description is [.., (byte)'\n' or (byte)'\r'] or [] ? [.. description, .. values] : [.. description, (byte)'\n', .. values];
    }

    private static string? DescriptionOf(string path) =>
        DescriptionsOf(path).FirstOrDefault(p => new FileInfo(p) is { Exists: true, LinkTarget: null });
}
