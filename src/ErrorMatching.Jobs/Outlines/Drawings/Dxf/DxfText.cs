using System.Globalization;
using System.Text;

namespace ErrorMatching.Jobs;

/// <summary>Decodes names of a DXF file. Since 2007 the format is in UTF-8, before in a code page; many programs write UTF-8
/// always.</summary>
internal sealed class DxfText
{
    private static readonly UTF8Encoding Utf8 = new(false, true);
    private Encoding _page = Page(1252);
    private bool _isPageFirst;

    /// <summary>Sets the code page that the header states, such as <c>ANSI_932</c>; what is unknown changes nothing.</summary>
    public void SetPage(string name)
    {
        var digits = name.AsSpan(name.LastIndexOf('_') + 1);
        digits = digits.StartsWith("DOS", StringComparison.OrdinalIgnoreCase) ? digits[3..] : digits;
        var number = int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out var n) ? n
            : name.Equals("gb2312", StringComparison.OrdinalIgnoreCase) ? 936
            : name.Equals("big5", StringComparison.OrdinalIgnoreCase) ? 950
            : 1252;
        try
        {
            _page = Page(number);
        }
        catch (ArgumentException)
        {
            return;
        }
        catch (NotSupportedException)
        {
            return;
        }

        // Characters of two bytes are often valid UTF-8 by chance; those of one byte hardly ever are.
        _isPageFirst = number is 932 or 936 or 949 or 950;
    }

    /// <summary>Sets the version that the header states.</summary>
    public void SetVersion(string version) =>
        IsUtf8 = version.StartsWith("AC", StringComparison.Ordinal) && string.CompareOrdinal(version, "AC1021") >= 0;

    /// <summary>True if the version requires UTF-8.</summary>
    public bool IsUtf8 { get; private set; }

    /// <summary>A name without the escapes of the format.</summary>
    public string Decode(ReadOnlySpan<byte> bytes)
    {
        var text = Plain(bytes);
        return text.Contains("\\U+", StringComparison.OrdinalIgnoreCase) ? Unescape(text) : text;
    }

    private static string Unescape(string text)
    {
        var result = new StringBuilder();
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] == '\\' && i + 7 <= text.Length && text[i + 1] is 'U' or 'u' && text[i + 2] == '+'
                && ushort.TryParse(text.AsSpan(i + 3, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var code))
            {
                result.Append((char)code);
                i += 6;
            }
            else
            {
                result.Append(text[i]);
            }
        }

        return result.ToString();
    }

    private static Encoding Page(int number) =>
        CodePagesEncodingProvider.Instance.GetEncoding(number, EncoderFallback.ExceptionFallback, DecoderFallback.ExceptionFallback)
            ?? Encoding.Latin1;

    private string Plain(ReadOnlySpan<byte> bytes)
    {
        if (!bytes.ContainsAnyExceptInRange((byte)0, (byte)127))
        {
            return Encoding.ASCII.GetString(bytes);
        }

        var (first, second) = _isPageFirst && !IsUtf8 ? (_page, (Encoding)Utf8) : (Utf8, _page);
        return Strict(first, bytes) ?? Strict(second, bytes) ?? Encoding.Latin1.GetString(bytes);
    }

    private static string? Strict(Encoding encoding, ReadOnlySpan<byte> bytes)
    {
        try
        {
            return encoding.GetString(bytes);
        }
        catch (DecoderFallbackException)
        {
            return null;
        }
    }
}
