using System.Text;

namespace ErrorMatching.Nc;

/// <summary>The words of a block of Klartext after its path function: coordinates, radius, compensation, feed and functions.</summary>
internal static class KlartextWords
{
    // M functions with words of their own, up to the next M function: what looks like a coordinate there is none.
    private static readonly int[] WithWords = [101, 102, 103, 112, 118, 120, 124, 128, 140, 142, 143];

    /// <summary>True for an M function of the control itself.</summary>
    public static bool IsOfControl(long function) => function is >= 89 and <= 199;

    /// <summary>The word that begins with a letter.</summary>
    public static NcToken At(in BlockScanner text, int at, BlockPlace place)
    {
        var letter = (byte)(text.Bytes[at] & ~0x20);
        switch (letter)
        {
            case (byte)'I' when text.ValueAt(at, "IPR"u8, out var value):
                return text.Coordinate(NcTokenKind.PolarWord, (byte)'@', at, value, WordDistance.Incremental);
            case (byte)'I' when text.ValueAt(at, "IPA"u8, out var value):
                return text.Coordinate(NcTokenKind.PolarWord, (byte)'^', at, value, WordDistance.Incremental);
            case (byte)'I' when at + 1 < text.End && IsAxis((byte)(text.Bytes[at + 1] & ~0x20))
                && text.ValueAt(at, text.Bytes.Slice(at, 2), out var value):
                return text.Coordinate(NcTokenKind.Word, (byte)(text.Bytes[at + 1] & ~0x20), at, value, WordDistance.Incremental);
            case (byte)'P' when text.ValueAt(at, "PR"u8, out var value):
                return text.Coordinate(NcTokenKind.PolarWord, (byte)'@', at, value, WordDistance.Absolute);
            case (byte)'P' when text.ValueAt(at, "PA"u8, out var value):
                return text.Coordinate(NcTokenKind.PolarWord, (byte)'^', at, value, WordDistance.Absolute);
            case (byte)'L' when text.ValueAt(at, "LEN"u8, out var value):
                return text.Coordinate(NcTokenKind.Word, (byte)'L', at, value, WordDistance.Modal);
            case (byte)'C' when text.ValueAt(at, "CCA"u8, out var value):
                return text.Coordinate(NcTokenKind.Word, NcAddress.OpeningAngle, at, value, WordDistance.Modal);
            case (byte)'Q' when text.ParameterEnd(at) is > 0 and var end && place is BlockPlace.Tool or BlockPlace.Chamfer:
                return place == BlockPlace.Tool ? BlockScanner.Valued(NcTokenKind.ExpressionWord, (byte)'T', at, at, end)
                    : BlockScanner.Valued(NcTokenKind.CommaWord, (byte)'C', at, at, end);
            case (byte)'R' when text.IsRadiusOff(at):
                return BlockScanner.Plain(NcTokenKind.Keyword, at, at + 2);
            case (byte)'M' when text.ValueAt(at, "M"u8, out var value):
                return text.FunctionAt(at, value);
        }

        if ((IsAxis(letter) || letter is (byte)'R' or (byte)'F' or (byte)'S') && text.ValueAt(at, text.Bytes.Slice(at, 1), out var behind))
        {
            return text.Coordinate(NcTokenKind.Word, letter, at, behind, WordDistance.Modal);
        }

        // An axis without a coordinate has a meaning in a tool call only.
        var keywordEnd = text.WordEnd(at);
        return BlockScanner.Plain(
            IsAxis(letter) && keywordEnd == at + 1 && place != BlockPlace.Tool ? NcTokenKind.Invalid : NcTokenKind.Keyword, at, keywordEnd);
    }

    /// <summary>The end of a Q parameter (Q5, QL5, QR5, QS5); 0 if none begins here.</summary>
    public static int ParameterEnd(this in BlockScanner text, int at)
    {
        if (at >= text.End || (text.Bytes[at] | 0x20) != 'q')
        {
            return 0;
        }

        at++;
        at += at < text.End && (text.Bytes[at] | 0x20) is 'l' or 'r' or 's' ? 1 : 0;
        var digits = at;
        while (at < text.End && SyntaxBytes.IsDigit(text.Bytes[at]))
        {
            at++;
        }

        return at > digits ? at : 0;
    }

    private static bool IsAxis(byte letter) => letter is (>= (byte)'A' and <= (byte)'C') or (>= (byte)'U' and <= (byte)'Z');

    // True at an address that has a number or a parameter as its value, and the value's position.
    private static bool ValueAt(this in BlockScanner text, int at, ReadOnlySpan<byte> address, out int value)
    {
        value = at + address.Length;
        if (value >= text.End || !Ascii.EqualsIgnoreCase(text.Bytes[at..value], address))
        {
            return false;
        }

        value = text.SkipSpaces(value);
        return text.ReadNumber(value, out _, out _) || text.ParameterEnd(text.BehindSign(value)) > 0;
    }

    private static int BehindSign(this in BlockScanner text, int at) =>
        at < text.End && text.Bytes[at] is (byte)'+' or (byte)'-' ? at + 1 : at;

    private static NcToken Coordinate(this in BlockScanner text, NcTokenKind kind, byte letter, int at, int value, WordDistance distance)
    {
        if (text.ReadNumber(value, out var next, out var number))
        {
            return new(kind, letter, at, next - at, value, next - value, number, distance);
        }

        var end = text.ParameterEnd(text.BehindSign(value));
        kind = kind == NcTokenKind.Word ? NcTokenKind.ExpressionWord : kind;
        return new(kind, letter, at, end - at, value, end - value, default, distance);
    }

    // R0 is the end of radius compensation; R0.5 and R05 are radii.
    private static bool IsRadiusOff(this in BlockScanner text, int at) => at + 1 < text.End && text.Bytes[at + 1] == '0'
        && (at + 2 >= text.End || !(SyntaxBytes.IsDigit(text.Bytes[at + 2]) || text.Bytes[at + 2] is (byte)'.' or (byte)','));

    private static NcToken FunctionAt(this in BlockScanner text, int at, int value)
    {
        var word = text.Coordinate(NcTokenKind.Word, (byte)'M', at, value, WordDistance.Modal);
        if (word.Kind != NcTokenKind.Word || word.Number.Decimals > 0 || !IsOfControl(word.Number.Digits))
        {
            return word;
        }

        if (Array.IndexOf(WithWords, (int)Math.Clamp(word.Number.Digits, 0, int.MaxValue)) < 0)
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, at, word.End);
        }

        var end = word.End;
        for (var next = end; next < text.End && text.Bytes[next] != ';'; next++)
        {
            if ((text.Bytes[next] | 0x20) == 'm' && next + 1 < text.End && SyntaxBytes.IsDigit(text.Bytes[next + 1]))
            {
                break;
            }

            end = SyntaxBytes.IsSpace(text.Bytes[next]) || text.Bytes[next] == '~' ? end : next + 1;
        }

        return BlockScanner.Plain(NcTokenKind.Keyword, at, end);
    }

    // A name with the number, the sign or the parameter that follows it: DR+, DL-0.2, MB50, FZ0.1. F MAX is one word.
    private static int WordEnd(this in BlockScanner text, int at)
    {
        var end = at;
        while (end < text.End && SyntaxBytes.IsLetter(text.Bytes[end]))
        {
            end++;
        }

        var second = text.SkipSpaces(end);
        if (end == at + 1 && (text.Bytes[at] | 0x20) == 'f' && second > end)
        {
            foreach (var name in (ReadOnlySpan<string>)["MAX", "AUTO"])
            {
                if (second + name.Length <= text.End && Ascii.EqualsIgnoreCase(text.Bytes.Slice(second, name.Length), name))
                {
                    return second + name.Length;
                }
            }
        }

        if (text.ReadNumber(end, out var next, out _))
        {
            return next;
        }

        var parameter = text.ParameterEnd(text.BehindSign(end));
        return parameter > 0 ? parameter : text.BehindSign(end);
    }
}
