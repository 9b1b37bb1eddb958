using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>The spelling of a program's number, used to write its new value in the same style.</summary>
/// <param name="Plus">Positive values have a plus sign.</param>
/// <param name="Point">Whole numbers have a point too.</param>
/// <param name="LeadingZero">Values below one have a zero before the point.</param>
/// <param name="FixedDecimals">Minimum number of decimals; -1 if trailing zeros are omitted.</param>
/// <param name="WholeDigits">Minimum number of digits before the point.</param>
internal readonly record struct NumberStyle(bool Plus, bool Point, bool LeadingZero, int FixedDecimals, int WholeDigits)
{
    /// <summary>The style of a number as written.</summary>
    /// <remarks>
    /// Trailing zeros (<c>10.500</c>) show that decimals are fixed. <c>10.123</c> is ambiguous and counts as trimmed unless
    /// <paramref name="programIsFixed"/> says that the program pads elsewhere.
    /// </remarks>
    public static NumberStyle Of(ReadOnlySpan<byte> number, bool programIsFixed)
    {
        var plus = number.Length > 0 && number[0] == '+';
        var unsigned = number.Length > 0 && number[0] is (byte)'+' or (byte)'-' ? number[1..] : number;
        var point = unsigned.IndexOf((byte)'.');
        var whole = point < 0 ? unsigned : unsigned[..point];
        var decimals = point < 0 ? 0 : unsigned.Length - point - 1;
        var padded = decimals > 0 && (unsigned[^1] == '0' || programIsFixed);
        return new(
            plus,
            point >= 0,
            whole.Length > 0,
            padded ? decimals : -1,
            whole.Length > 1 && whole[0] == '0' ? whole.Length : Math.Min(1, whole.Length));
    }

    /// <summary>Maximum length of a number's text, in bytes, in any style.</summary>
    internal const int LongestText = 64;

    /// <summary>Writes a value in this style.</summary>
    public byte[] Format(NcNumber value)
    {
        Span<byte> text = stackalloc byte[LongestText];
        return text[..Write(value, text)].ToArray();
    }

    /// <summary>Writes a value in this style and returns the length of its text.</summary>
    internal int Write(NcNumber value, Span<byte> text)
    {
        var trimmed = value.Trim();
        var padded = FixedDecimals > trimmed.Decimals ? trimmed.WithDecimals(FixedDecimals) : trimmed;
        var length = 0;
        if (padded.Digits < 0 || Plus)
        {
            text[length++] = (byte)(padded.Digits < 0 ? '-' : '+');
        }

        Span<byte> digits = stackalloc byte[NcNumber.MaxDigits + 2];
        Math.Abs(padded.Digits).TryFormat(digits, out var count, default, CultureInfo.InvariantCulture);
        var whole = padded.Digits == 0 ? 0 : count - padded.Decimals;
        var zeros = Math.Min(Math.Max(WholeDigits, LeadingZero || padded.Decimals == 0 ? 1 : 0), LongestText / 2) - Math.Max(0, whole);
        for (; zeros > 0; zeros--)
        {
            text[length++] = (byte)'0';
        }

        if (whole > 0)
        {
            digits[..whole].CopyTo(text[length..]);
            length += whole;
        }

        if (padded.Decimals > 0 || Point)
        {
            text[length++] = (byte)'.';
        }

        for (var i = padded.Decimals; i > 0; i--)
        {
            text[length++] = i > count ? (byte)'0' : digits[count - i];
        }

        return length;
    }
}
