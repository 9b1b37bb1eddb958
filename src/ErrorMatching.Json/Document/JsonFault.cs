using System.Globalization;
using System.Text;

namespace ErrorMatching.Json;

/// <summary>What is wrong at a place of a text that is no JSON, as a person who wrote it would say.</summary>
/// <param name="At">Index of the byte where it begins.</param>
/// <param name="Found">The finding, as the middle of a sentence.</param>
/// <param name="Expected">What is expected, as the end of a sentence without a period.</param>
internal readonly record struct JsonFault(int At, string Found, string Expected)
{
    private const string Behind = "a comma or a closing bracket";
    private const string Value = "a value: a number, true, false, null, or a text in double quotes";

    /// <summary>Judges a text.</summary>
    /// <param name="bytes">The text in UTF-8.</param>
    /// <param name="at">Where the reader stopped.</param>
    public static JsonFault Of(ReadOnlySpan<byte> bytes, int at)
    {
        at = Math.Clamp(at, 0, bytes.Length);
        var context = new Context();
        context.Read(bytes[..at]);
        if (context.TextStart is { } start)
        {
            return InText(bytes, at, start);
        }

        if (DecimalComma(bytes, at) is { } comma)
        {
            return comma;
        }

        if (at == bytes.Length)
        {
            return new(at, "the end of the file", context.Open is { } open
                ? string.Create(CultureInfo.InvariantCulture, $"{Closing(open.Bracket)} for the {(char)open.Bracket} in line {open.Line}")
                : context.Last == (byte)':' ? Value : "the rest of the document");
        }

        if (context.IsComplete)
        {
            return new(at, $"{WordAt(bytes, at)} behind the document", "one JSON value alone");
        }

        return OfSign(bytes, at, context) ?? OfWord(bytes, at, context);
    }

    private static JsonFault? OfSign(ReadOnlySpan<byte> bytes, int at, in Context context)
    {
        var sign = bytes[at];
        switch (sign)
        {
            case (byte)',':
                return context.Last == (byte)','
                    ? new(at, "a second comma", context.IsKeyNext ? "one comma, then a key" : "one comma, then a value")
                    : new(at, "a comma without a value in front of it", context.IsKeyNext ? "a key" : Value);
            case (byte)'\'':
                return new(at, "a single quotation mark", "a double quotation mark (\")");
            case (byte)';':
                return new(at, "a semicolon", Behind);
            case (byte)'=':
                return new(at, "an equals sign", "a colon between the key and its value");
            case (byte)':':
                return new(at, "a colon", context.EndsValue ? Behind : context.IsKeyNext ? "a key in double quotes" : Value);
            case (byte)'"' or (byte)'{' or (byte)'[' when context.EndsValue:
                return context.IsKey
                    ? new(at, WordAt(bytes, at), "a colon between the key and its value")
                    : new(at, $"{WordAt(bytes, at)} without a comma in front of it", "a comma between two entries");
            case (byte)'}' or (byte)']':
                return context.Open is { } open && Closing(open.Bracket)[0] != sign
                    ? new(at, ((char)sign).ToString(), string.Create(
                        CultureInfo.InvariantCulture, $"{Closing(open.Bracket)} for the {(char)open.Bracket} in line {open.Line}"))
                    : new(at, ((char)sign).ToString(), context.IsKey ? "a colon and a value behind the key" : Value);
            default:
                return null;
        }
    }

    private static JsonFault OfWord(ReadOnlySpan<byte> bytes, int at, in Context context)
    {
        var number = NumberStart(bytes, at);
        if (!context.IsKeyNext && number >= 0)
        {
            var token = Token(bytes, number);
            return new(number, $"the number {token}", "a number such as 12, 0.5 or -1e-3: digits on both sides of the point, no plus sign, "
                + "no zero in front of other digits");
        }

        var word = WordAt(bytes, at);
        if (word is "\u201C" or "\u201D" or "\u201E" or "\u2018" or "\u2019" or "\u00AB" or "\u00BB")
        {
            return new(at, $"the quotation mark {word}", "a straight one (\")");
        }

        var small = word.ToLowerInvariant();
        return context is { EndsValue: true, IsKey: true } ? new(at, word, "a colon between the key and its value")
            : context.EndsValue ? new(at, $"{word} behind a value", Behind + " (units belong to the key)")
            : context.IsKeyNext ? new(at, word, $"a key in double quotes (\"{word}\")")
            : small is "true" or "false" or "null" ? new(at, word, $"{small} in small letters")
            : small is "nan" or "infinity" or "inf" ? new(at, word, "a number")
            : new(at, word, Value);
    }

    private static JsonFault InText(ReadOnlySpan<byte> bytes, int at, int start)
    {
        if (at >= bytes.Length)
        {
            return new(start, "a text that does not end", "a closing quotation mark (\")");
        }

        // The reader stops at the character behind the backslash.
        return bytes[at - 1] == (byte)'\\'
            ? new(at, $"\\{CharacterAt(bytes, at)} in a text", "\\\\ for a backslash, or / between folders")
            : bytes[at] is (byte)'\n' or (byte)'\r'
                ? new(start, "a text that does not end in its line", "a closing quotation mark (\")")
            : new(at, string.Create(CultureInfo.InvariantCulture, $"the character 0x{bytes[at]:X2} in a text"),
                "a text without control characters");
    }

    // 0,02: the reader stops behind the comma, or at a digit behind a zero there.
    private static JsonFault? DecimalComma(ReadOnlySpan<byte> bytes, int at)
    {
        var comma = at - 1;
        while (comma > 0 && char.IsAsciiDigit((char)bytes[comma]))
        {
            comma--;
        }

        if (at >= bytes.Length || comma < 1 || bytes[comma] != (byte)',' || !char.IsAsciiDigit((char)bytes[comma - 1])
            || !char.IsAsciiDigit((char)bytes[comma + 1]))
        {
            return null;
        }

        var start = comma - 1;
        while (start > 0 && (char.IsAsciiDigit((char)bytes[start - 1]) || bytes[start - 1] == (byte)'-'))
        {
            start--;
        }

        var token = Token(bytes, start, withComma: true);
        return new(start, $"the number {token} with a comma", $"a decimal point ({token.Replace(',', '.')})");
    }

    // The start of what looks like a number around a place; -1 if nothing does.
    private static int NumberStart(ReadOnlySpan<byte> bytes, int at)
    {
        var start = at;
        while (start > 0 && IsOfNumber(bytes[start - 1]))
        {
            start--;
        }

        var token = Token(bytes, start);
        return token.AsSpan().IndexOfAnyInRange('0', '9') >= 0 && (char.IsAsciiDigit(token[0]) || token[0] is '+' or '-' or '.')
            && (start < at || token[0] is '+' or '.')
            ? start
            : -1;
    }

    private static bool IsOfNumber(byte b) => char.IsAsciiDigit((char)b)
        || b is (byte)'+' or (byte)'-' or (byte)'.' or (byte)'e' or (byte)'E';

    private static string Token(ReadOnlySpan<byte> bytes, int start, bool withComma = false)
    {
        var end = start;
        while (end < bytes.Length && (IsOfNumber(bytes[end]) || (withComma && bytes[end] == (byte)',')))
        {
            end++;
        }

        return Encoding.ASCII.GetString(bytes[start..Math.Min(end, start + 40)]).TrimEnd(',');
    }

    private static string CharacterAt(ReadOnlySpan<byte> bytes, int at)
    {
        _ = Rune.DecodeFromUtf8(bytes[at..], out var rune, out _);
        return rune.ToString();
    }

    // A word of letters and digits, or one character.
    private static string WordAt(ReadOnlySpan<byte> bytes, int at)
    {
        var end = at;
        while (end < bytes.Length && end - at < 40 && (char.IsAsciiLetterOrDigit((char)bytes[end]) || bytes[end] == (byte)'_'))
        {
            end++;
        }

        return end > at ? Encoding.ASCII.GetString(bytes[at..end]) : CharacterAt(bytes, at);
    }

    private static string Closing(byte bracket) => bracket == (byte)'{' ? "}" : "]";

    // What a reader knows in front of a place.
    private struct Context()
    {
        private readonly Stack<(byte Bracket, int Line)> _open = new();
        private int _line = 1;

        // The last byte that is no blank and no comment; a quotation mark for a text.
        public byte Last { get; private set; }

        // Where a text began that is not closed.
        public int? TextStart { get; private set; }

        // The last text is a key.
        public bool IsKey { get; private set; }

        public readonly (byte Bracket, int Line)? Open => _open.Count > 0 ? _open.Peek() : null;

        public readonly bool EndsValue => Last != 0 && Last is not ((byte)'{' or (byte)'[' or (byte)',' or (byte)':');

        public readonly bool IsComplete => _open.Count == 0 && EndsValue;

        public readonly bool IsKeyNext => Open is { Bracket: (byte)'{' } && Last is (byte)'{' or (byte)',';

        public void Read(ReadOnlySpan<byte> bytes)
        {
            for (var i = 0; i < bytes.Length; i++)
            {
                var b = bytes[i];
                switch (b)
                {
                    case (byte)'\n':
                        _line++;
                        break;
                    case (byte)' ' or (byte)'\t' or (byte)'\r':
                        break;
                    case (byte)'/' when i + 1 < bytes.Length && bytes[i + 1] is (byte)'/' or (byte)'*':
                        i = BehindComment(bytes, i);
                        break;
                    case (byte)'"':
                        IsKey = IsKeyNext;
                        var end = EndOfText(bytes, i);
                        if (end < 0)
                        {
                            TextStart = i;
                            return;
                        }

                        (i, Last) = (end, b);
                        break;
                    default:
                        Take(b);
                        break;
                }
            }
        }

        private void Take(byte b)
        {
            if (b is (byte)'{' or (byte)'[')
            {
                _open.Push((b, _line));
            }
            else if (b is (byte)'}' or (byte)']')
            {
                _ = _open.TryPop(out _);
            }

            (Last, IsKey) = (b, false);
        }

        private int BehindComment(ReadOnlySpan<byte> bytes, int at)
        {
            var isLine = bytes[at + 1] == (byte)'/';
            var rest = bytes[(at + 2)..];
            var length = isLine ? rest.IndexOf((byte)'\n') : rest.IndexOf("*/"u8);
            var end = length < 0 ? bytes.Length : at + 2 + length + (isLine ? 0 : 2);
            _line += bytes[at..end].Count((byte)'\n');
            return end - 1;
        }

        private static int EndOfText(ReadOnlySpan<byte> bytes, int at)
        {
            for (var i = at + 1; i < bytes.Length; i++)
            {
                if (bytes[i] == (byte)'\\')
                {
                    i++;
                }
                else if (bytes[i] == (byte)'"')
                {
                    return i;
                }
            }

            return -1;
        }
    }
}
