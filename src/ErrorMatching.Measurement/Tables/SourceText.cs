using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Decodes the bytes of a file, refusing every byte that is invalid in the encoding.</summary>
internal static class SourceText
{
    private static readonly (string Name, Func<Encoding> Encoding)[] Encodings =
    [
        ("utf-8", () => new UTF8Encoding(false, true)),
        ("utf-16", () => new UnicodeEncoding(false, false, true)),
        ("utf-16be", () => new UnicodeEncoding(true, false, true)),
        ("latin-1", () => Encoding.Latin1),
        ("windows-1252", () => CodePage(1252)),
        ("gb18030", () => CodePage(54936)),
        ("shift-jis", () => CodePage(932)),
        ("big5", () => CodePage(950)),
    ];

    public static IReadOnlyList<string> EncodingNames { get; } = [.. Encodings.Select(e => e.Name)];

    /// <summary>Decodes a file that shows its own format: as its byte order mark says, or in UTF-8, or else in the job's encoding, which
    /// is windows-1252 unless the job names one.</summary>
    /// <param name="bytes">The bytes.</param>
    /// <param name="file">The file name, for messages.</param>
    /// <param name="encoding">The encoding of the job's format.</param>
    /// <param name="controls">Control characters that belong to the format.</param>
    public static string DecodeOwn(ReadOnlySpan<byte> bytes, string file, string encoding, string controls = "")
    {
        var named = encoding is "utf-8" or "utf-16" or "utf-16be" ? "windows-1252" : encoding;
        var marked = bytes is [0xFF, 0xFE, ..] ? "utf-16" : bytes is [0xFE, 0xFF, ..] ? "utf-16be" : "utf-8";
        try
        {
            return Decode(bytes, file, marked, '\t', controls);
        }
        catch (InputException e) when (e.Code == MeasurementError.InvalidEncoding && marked == "utf-8")
        {
            return Decode(bytes, file, named, '\t', controls);
        }
    }

    /// <summary>Decodes a file without its byte order mark.</summary>
    /// <exception cref="InputException">The file is empty, is not text, or is text of another encoding.</exception>
    public static string Decode(ReadOnlySpan<byte> bytes, string file, string encodingName, char delimiter, string controls = "")
    {
        bytes = WithoutByteOrderMark(bytes, file, ref encodingName);
        if (encodingName is not ("utf-16" or "utf-16be") && bytes.IndexOf((byte)0) is var nul and >= 0)
        {
            throw Binary(PlaceAfter(Encoding.Latin1.GetString(bytes[..nul]), file, delimiter), '\0');
        }

        var name = encodingName;
        var encoding = Array.Find(Encodings, e => e.Name == name).Encoding?.Invoke()
            ?? throw new ArgumentException($"There is no encoding named {name}.", nameof(encodingName));
        string text;
        try
        {
            text = encoding.GetString(bytes);
        }
        catch (DecoderFallbackException e)
        {
            var bad = FirstBad(bytes, encoding);
            throw PlaceAfter(encoding.GetString(bytes[..bad]), file, delimiter).Fail(
                MeasurementError.InvalidEncoding,
                string.Create(CultureInfo.InvariantCulture, $"byte 0x{bytes[bad]:X2}, which is no {encodingName} text"),
                "text in " + encodingName + ": export the file in this encoding, or name the file's own in its format",
                e);
        }

        var control = text.AsSpan().IndexOfAnyInRange('\0', '\b') is var low and >= 0 ? low : HighControl(text, controls);
        return control < 0 ? text : throw Binary(PlaceAfter(text[..control], file, delimiter), text[control]);
    }

    // After tab, line breaks and form feed.
    private static int HighControl(string text, string allowed)
    {
        for (var at = 0; ;)
        {
            var next = text.AsSpan(at).IndexOfAnyInRange('\u000e', '\u001f');
            if (next < 0 || !allowed.Contains(text[at + next], StringComparison.Ordinal))
            {
                return next < 0 ? -1 : at + next;
            }

            at += next + 1;
        }
    }

    private static InputException Binary(Place place, char control) => place.Fail(
        MeasurementError.BinaryFile,
        string.Create(CultureInfo.InvariantCulture, $"the control character 0x{(int)control:X2}, as in a binary file or in UTF-16 text"),
        "text with delimited columns: export the measurement as CSV, or name the encoding in its format");

    private static ReadOnlySpan<byte> WithoutByteOrderMark(ReadOnlySpan<byte> bytes, string file, scoped ref string encodingName)
    {
        ReadOnlySpan<byte> utf8 = [0xEF, 0xBB, 0xBF], little = [0xFF, 0xFE], big = [0xFE, 0xFF];
        var (mark, length) = bytes.StartsWith(utf8)
            ? ("utf-8", 3)
            : bytes.StartsWith(little)
            ? ("utf-16", 2)
            : bytes.StartsWith(big)
            ? ("utf-16be", 2)
            : (encodingName, 0);
        var wide = encodingName is "utf-16" && mark is "utf-16be";
        if (mark != encodingName && !wide)
        {
            throw Place.Start(file).Fail(
                MeasurementError.InvalidEncoding,
                $"the byte order mark of {mark}",
                $"text in {encodingName}: export the file in this encoding, or set the encoding of its format to {mark}");
        }

        encodingName = mark;
        return bytes[length..];
    }

    // The index reported by a decoder depends on the encoding, so bytes are decoded one by one to find the location.
    private static int FirstBad(ReadOnlySpan<byte> bytes, Encoding encoding)
    {
        var decoder = encoding.GetDecoder();
        var chars = new char[encoding.GetMaxCharCount(1)];
        var start = 0;
        for (var i = 0; i < bytes.Length; i++)
        {
            try
            {
                if (decoder.GetChars(bytes.Slice(i, 1), chars, i == bytes.Length - 1) > 0)
                {
                    start = i + 1;
                }
            }
            catch (DecoderFallbackException)
            {
                return start;
            }
        }

        return start;
    }

    private static Place PlaceAfter(string text, string file, char delimiter)
    {
        var lineStart = 0;
        var line = 1 + LineBreaks.Count(text, ref lineStart);
        return new(file, line, 1 + text.AsSpan(lineStart).Count(delimiter));
    }

    private static Encoding CodePage(int number) =>
        CodePagesEncodingProvider.Instance.GetEncoding(number, EncoderFallback.ExceptionFallback, DecoderFallback.ExceptionFallback)!;
}
