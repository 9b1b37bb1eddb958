using System.Buffers.Text;

namespace ErrorMatching.Nc;

/// <summary>Reads numbers and texts of expressions.</summary>
internal static class ExpressionLiterals
{
    /// <summary>Reads a number without sign.</summary>
    public static NcValue Number(ref ExpressionText text, NcSyntax syntax)
    {
        if (TryShort(ref text, syntax, out var exact))
        {
            return NcValue.Of(exact);
        }

        Span<byte> digits = stackalloc byte[64];
        var (start, length, points) = (text.At, 0, 0);
        for (; SyntaxBytes.IsDigit(text.Peek()) || text.Peek() == '.' || (syntax == NcSyntax.LinuxCnc && SpaceInNumber(text)); text.At++)
        {
            if (text.Peek() is (byte)' ' or (byte)'\t')
            {
                continue;
            }

            points += text.Peek() == '.' ? 1 : 0;
            if (length == digits.Length || points > 1)
            {
                return text.FailAt(start, points > 1 ? "a number has two points" : "a number has too many digits");
            }

            digits[length++] = text.Peek();
        }

        if (syntax == NcSyntax.Siemens && text.StandsHere("EX") && length < digits.Length - 8)
        {
            digits[length++] = (byte)'E';
            text.At += 2;
            for (var first = text.At; (SyntaxBytes.IsDigit(text.Peek()) || (text.At == first && text.Peek() is (byte)'-' or (byte)'+'))
                && text.At - first < 5; text.At++)
            {
                digits[length++] = text.Peek();
            }
        }

        return Utf8Parser.TryParse(digits[..length], out double value, out var read) && read == length && double.IsFinite(value)
            ? NcValue.Of(value)
            : text.FailAt(start, "this is no number");
    }

    // Digits with at most one point, up to what a double holds exactly, and nothing behind that could belong to the number: one division,
    // which rounds once as parsing does.
    private static bool TryShort(ref ExpressionText text, NcSyntax syntax, out double value)
    {
        var rest = text.Rest;
        var (at, digits, count, point) = (0, 0L, 0, -1);
        for (; at < rest.Length && (SyntaxBytes.IsDigit(rest[at]) || (rest[at] == '.' && point < 0)); at++)
        {
            if (rest[at] == '.')
            {
                point = count;
            }
            else if (++count <= NcNumber.ExactDigits)
            {
                digits = (10 * digits) + (rest[at] - '0');
            }
        }

        var isShort = count is > 0 and <= NcNumber.ExactDigits
            && (at == rest.Length || rest[at] is (byte)']' or (byte)'*' or (byte)'/' or (byte)'+' or (byte)'-'
                || (syntax != NcSyntax.Siemens && SyntaxBytes.IsLetter(rest[at])));
        value = isShort ? new NcNumber(digits, point < 0 ? 0 : count - point).Value : 0;
        text.At += isShort ? at : 0;
        return isShort;
    }

    /// <summary>Reads a text in quotation marks.</summary>
    public static NcValue Quoted(ref ExpressionText text)
    {
        var inside = text.Rest[1..];
        var length = inside.IndexOf((byte)'"');
        if (length < 0)
        {
            return text.Fail("a text is not closed: a quotation mark is missing");
        }

        text.At += length + 2;
        return NcValue.Of(NcText.Decode(inside[..length]));
    }

    /// <summary>Reads a number in apostrophes: <c>'H1F'</c> is hexadecimal, <c>'B101'</c> binary.</summary>
    public static NcValue Coded(ref ExpressionText text)
    {
        var inside = text.Rest[1..];
        var length = inside.IndexOf((byte)'\'');
        var digits = length < 2 ? default : inside[1..length];
        var (radix, value) = ((text.Peek(1) | 0x20) == 'h' ? 16 : (text.Peek(1) | 0x20) == 'b' ? 2 : 0, 0.0);
        if (digits.Length is 0 or > 32 || radix == 0)
        {
            return text.Fail("this is no number");
        }

        foreach (var c in digits)
        {
            var digit = SyntaxBytes.IsDigit(c) ? c - '0' : (c | 0x20) is >= 'a' and <= 'f' ? (c | 0x20) - 'a' + 10 : radix;
            if (digit >= radix)
            {
                return text.Fail("this is no number");
            }

            value = (value * radix) + digit;
        }

        text.At += length + 2;
        return NcValue.Of(value);
    }

    // LinuxCNC ignores spaces in numbers: 1 2 is 12.
    private static bool SpaceInNumber(in ExpressionText text)
    {
        var behind = text.BehindSpaces(0);
        return behind > 0 && (SyntaxBytes.IsDigit(text.Peek(behind)) || text.Peek(behind) == '.');
    }
}
