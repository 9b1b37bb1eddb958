using System.Globalization;
using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>Strings in STEP files, which escape non-ASCII characters with backslashes (ISO 10303-21, section 6.4.3).</summary>
internal static class StepText
{
    /// <summary>Decodes the string between two quotation marks. Invalid escapes are kept.</summary>
    public static string Read(string text, Range range)
    {
        var (start, length) = range.GetOffsetAndLength(text.Length);
        var raw = text.AsSpan(start, length);
        if (raw.IndexOfAny('\\', '\'', '\n') < 0)
        {
            return raw.ToString();
        }

        var result = new StringBuilder(length);
        for (var at = 0; at < raw.Length;)
        {
            var rest = raw[at..];
            at += rest[0] switch
            {
                '\'' => Append(result, "'", 2),
                '\r' or '\n' => 1,
                '\\' when rest.StartsWith("\\\\") => Append(result, "\\", 2),
                '\\' when rest.StartsWith(@"\X2\") => Wide(result, rest, 4),
                '\\' when rest.StartsWith(@"\X4\") => Wide(result, rest, 8),
                '\\' when rest.StartsWith(@"\X\") && rest.Length >= 5 && TryHex(rest.Slice(3, 2), out var code) =>
                    Append(result, ((char)code).ToString(), 5),
                '\\' when rest.StartsWith(@"\S\") && rest.Length >= 4 => Append(result, ((char)(rest[3] | 0x80)).ToString(), 4),
                _ => Append(result, rest[..1].ToString(), 1),
            };
        }

        return result.ToString();
    }

    /// <summary>Encodes a string, including the quotation marks.</summary>
    public static string Write(string value)
    {
        var result = new StringBuilder("'");
        var wide = false;
        foreach (var c in value)
        {
            var plain = c is >= ' ' and <= '~';
            if (plain == wide)
            {
                result.Append(plain ? @"\X0\" : @"\X2\");
                wide = !plain;
            }

            result.Append(
                plain
                    ? c switch { '\'' => "''", '\\' => "\\\\", _ => c.ToString() }
                    : ((int)c).ToString("X4", CultureInfo.InvariantCulture));
        }

        return result.Append(wide ? @"\X0\'" : "'").ToString();
    }

    private static int Append(StringBuilder result, string text, int taken)
    {
        result.Append(text);
        return taken;
    }

    // Groups of digits up to \X0\.
    private static int Wide(StringBuilder result, ReadOnlySpan<char> rest, int digits)
    {
        var end = rest.IndexOf(@"\X0\", StringComparison.Ordinal);
        var coded = rest[4..Math.Max(4, end)];
        var decoded = new StringBuilder();
        for (var i = 0; i + digits <= coded.Length; i += digits)
        {
            if (TryHex(coded.Slice(i, digits), out var code) && (code <= 0xFFFF || Rune.IsValid(code)))
            {
                decoded.Append(code <= 0xFFFF ? ((char)code).ToString() : new Rune(code).ToString());
            }
        }

        return end < 0 || coded.Length % digits != 0 ? Append(result, "\\", 1) : Append(result, decoded.ToString(), end + 4);
    }

    private static bool TryHex(ReadOnlySpan<char> digits, out int code) =>
        int.TryParse(digits, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out code) && code >= 0;
}
