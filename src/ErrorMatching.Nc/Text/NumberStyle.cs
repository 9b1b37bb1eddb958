using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc;

/// <summary>How a number of a program is spelled, so that its new value looks as if the same hand had written it.</summary>
/// <param name="Plus">A plus sign stands before positive values.</param>
/// <param name="Point">A point stands behind whole numbers too.</param>
/// <param name="LeadingZero">A zero stands before the point of values below one.</param>
/// <param name="FixedDecimals">At least this many decimals are written; -1 where zeros at the end are left out.</param>
/// <param name="WholeDigits">At least this many digits are written before the point.</param>
public readonly record struct NumberStyle(bool Plus, bool Point, bool LeadingZero, int FixedDecimals, int WholeDigits)
{
    /// <summary>The style of a number as written.</summary>
    /// <remarks>
    /// Zeros at the end (<c>10.500</c>) show that decimals are fixed; <c>10.123</c> could be either, and is taken as trimmed unless
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
        return new(plus, point >= 0, whole.Length > 0, padded ? decimals : -1, whole.Length > 1 && whole[0] == '0' ? whole.Length : Math.Min(1, whole.Length));
    }

    /// <summary>Writes a value in this style.</summary>
    public byte[] Format(NcNumber value)
    {
        var trimmed = value.Trim();
        var padded = FixedDecimals > trimmed.Decimals ? trimmed.WithDecimals(FixedDecimals) : trimmed;
        var digits = UnsignedDigits(padded);
        var (whole, fraction) = (digits[..^padded.Decimals], digits[^padded.Decimals..]);
        whole = whole.TrimStart('0').PadLeft(Math.Max(WholeDigits, LeadingZero || fraction.Length == 0 ? 1 : 0), '0');
        var text = new StringBuilder();
        text.Append(padded.Digits < 0 ? "-" : Plus ? "+" : "").Append(whole);
        if (fraction.Length > 0 || Point)
        {
            text.Append('.').Append(fraction);
        }

        return Encoding.ASCII.GetBytes(text.ToString());
    }

    private static string UnsignedDigits(NcNumber value) =>
        Math.Abs(value.Digits).ToString(CultureInfo.InvariantCulture).PadLeft(value.Decimals + 1, '0');
}
