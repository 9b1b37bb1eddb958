using System.Globalization;
using System.Text.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Json;

/// <summary>Reads handwritten JSON: UTF-8 with or without a byte order mark, with <c>//</c> and <c>/* */</c> comments and trailing commas.
/// Duplicate keys in an object are refused, because it is unclear which one is intended.</summary>
public static class JsonInput
{
    /// <summary>Loads the bytes of a file for <see cref="Read"/>; of an oversized file, just enough for it to report the size.</summary>
    /// <param name="path">The file.</param>
    /// <param name="limits">The size limits; <see cref="JsonLimits.Default"/> if null.</param>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
    public static byte[] Load(string path, JsonLimits? limits = null)
    {
        using var stream = SharedFile.OpenRead(path);

        // One byte more than allowed is enough to detect an oversized file.
        var most = (limits ?? JsonLimits.Default).MaxBytes;
        var bytes = new byte[(stream.CanSeek ? Math.Min(stream.Length, most) : most) + 1];
        return bytes[..stream.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false)];
    }

    /// <summary>Parses a document.</summary>
    /// <param name="bytes">UTF-8 text.</param>
    /// <param name="file">Name for messages.</param>
    /// <param name="limits">The size limits; <see cref="JsonLimits.Default"/> if null.</param>
    /// <exception cref="InputException">The document is too large
    /// (<c>too-big</c>), empty (<c>empty-document</c>), not UTF-8 (<c>not-utf8</c>), not JSON (<c>not-json</c>), nested too deeply
    /// (<c>too-deep</c>), has too many values (<c>too-many-values</c>), a number beyond the range of a double (<c>number-out-of-range</c>),
    /// or a duplicate key (<c>duplicate-key</c>). After 100 problems, <c>too-many-problems</c> is the last.</exception>
    public static JsonItem Read(ReadOnlySpan<byte> bytes, string file, JsonLimits? limits = null)
    {
        limits ??= JsonLimits.Default;
        if (bytes.Length > limits.MaxBytes)
        {
            throw Refuse(
                file,
                "too-big",
                new(1, 1),
                "a larger document",
                string.Create(CultureInfo.InvariantCulture, $"at most {limits.MaxBytes} bytes"));
        }

        var skipped = bytes.StartsWith("\uFEFF"u8) ? 3 : 0;
        bytes = bytes[skipped..];

        var map = new LineMap(bytes);
        if (map.FirstInvalidByte is { } invalid)
        {
            throw Refuse(
                file,
                "not-utf8",
                map.PlaceOf(bytes, invalid),
                string.Create(CultureInfo.InvariantCulture, $"the byte 0x{bytes[invalid]:X2}"),
                "UTF-8 text");
        }

        var tree = new TreeReader(map, file, skipped, limits.MaxValues);
        var reader = new Utf8JsonReader(
            bytes,
            new JsonReaderOptions
            {
                AllowTrailingCommas = true,
                CommentHandling = JsonCommentHandling.Skip,
                MaxDepth = limits.MaxDepth + 1
            });
        JsonItem root;
        try
        {
            if (!reader.Read())
            {
                throw Refuse(file, "empty-document", new(1, 1), "nothing", "one JSON value");
            }

            root = tree.ReadValue(ref reader, bytes, null, null, 0, limits.MaxDepth);

            // The reader itself refuses anything after the value.
            reader.Read();
        }
        catch (JsonException e)
        {
            throw bytes.IndexOfAnyExcept(" \t\r\n"u8) < 0
                ? Refuse(file, "empty-document", new(1, 1), "nothing", "one JSON value")
                : NotJson(file, bytes, map, map.IndexOf(e.LineNumber ?? 0, e.BytePositionInLine ?? 0, bytes.Length));
        }

        return tree.Problems.Count == 0 ? root : throw new InputException(file, tree.Problems);
    }

    private static InputException Refuse(string file, string code, JsonPlace place, string found, string expected) =>
        new(file, [JsonRefusal.At(place, "$", code, found, expected)]);

    private static InputException NotJson(string file, ReadOnlySpan<byte> bytes, LineMap map, int at)
    {
        var fault = JsonFault.Of(bytes, at);
        return Refuse(file, "not-json", map.PlaceOf(bytes, fault.At), fault.Found, fault.Expected);
    }
}
