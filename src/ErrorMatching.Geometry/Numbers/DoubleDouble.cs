using System.Globalization;
using System.Numerics;

namespace ErrorMatching.Geometry;

/// <summary>A number with about 32 digits: the unevaluated sum of two nonoverlapping doubles. It has the range of <c>double</c> and twice
/// its precision, enough for badly conditioned fits of measured decimals without loss.</summary>
/// <remarks>Algorithms and error bounds: Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic", ACM TOMS 44 (2017). With u = 2^-53, the relative errors are below 4 u^2 (sum), 5 u^2 (product) and 15 u^2
/// (quotient), where u^2 = 1.2e-32, unless an intermediate result overflows or underflows. An undefined operation (0/0, root of a negative
/// number) gives NaN, as for <c>double</c>.</remarks>
public readonly record struct DoubleDouble : IComparable<DoubleDouble>
{
    private DoubleDouble(double high, double low) => (High, Low) = (high, low);

    /// <summary>Zero.</summary>
    public static DoubleDouble Zero => default;

    /// <summary>One.</summary>
    public static DoubleDouble One => new(1, 0);

    /// <summary>The leading part: the nearest double.</summary>
    public double High { get; }

    /// <summary>The remainder: at most half a unit in the last place of the leading part.</summary>
    public double Low { get; }

    /// <summary>True if the number is neither NaN nor infinite.</summary>
    public bool IsFinite => double.IsFinite(High) && double.IsFinite(Low);

    /// <summary>The square root; NaN for a negative number.</summary>
    public static DoubleDouble Sqrt(DoubleDouble value)
    {
        var root = Math.Sqrt(value.High);
        if (root == 0 || !double.IsFinite(root))
        {
            return root;
        }

        var rest = Math.FusedMultiplyAdd(-root, root, value.High) + value.Low;
        return FastSum(root, rest / (2 * root));
    }

    /// <summary>The absolute value.</summary>
    public static DoubleDouble Abs(DoubleDouble value) => value.High < 0 || (value.High == 0 && value.Low < 0) ? -value : value;

    /// <summary>The nearest double.</summary>
    public double ToDouble() => High;

    /// <inheritdoc/>
    public int CompareTo(DoubleDouble other)
    {
        var byHigh = High.CompareTo(other.High);
        return byHigh != 0 ? byHigh : Low.CompareTo(other.Low);
    }

    /// <summary>Converts a double exactly.</summary>
    public static implicit operator DoubleDouble(double value) => new(value, 0);

    /// <summary>The negated number.</summary>
    public static DoubleDouble operator -(DoubleDouble a) => new(-a.High, -a.Low);

    /// <summary>The sum.</summary>
    public static DoubleDouble operator +(DoubleDouble a, DoubleDouble b)
    {
        var (high, highRest) = Sum(a.High, b.High);
        var (low, lowRest) = Sum(a.Low, b.Low);
        var first = FastSum(high, highRest + low);
        return FastSum(first.High, lowRest + first.Low);
    }

    /// <summary>The difference.</summary>
    public static DoubleDouble operator -(DoubleDouble a, DoubleDouble b) => a + -b;

    /// <summary>The product.</summary>
    public static DoubleDouble operator *(DoubleDouble a, DoubleDouble b)
    {
        var (high, rest) = Product(a.High, b.High);
        var cross = Math.FusedMultiplyAdd(a.Low, b.High, Math.FusedMultiplyAdd(a.High, b.Low, a.Low * b.Low));
        return FastSum(high, rest + cross);
    }

    /// <summary>The quotient.</summary>
    public static DoubleDouble operator /(DoubleDouble a, DoubleDouble b)
    {
        var high = a.High / b.High;
        var (product, rest) = Product(b.High, high);
        var back = FastSum(product, Math.FusedMultiplyAdd(b.Low, high, rest));
        return FastSum(high, (a.High - back.High + (a.Low - back.Low)) / b.High);
    }

    /// <summary>True if the first is smaller.</summary>
    public static bool operator <(DoubleDouble a, DoubleDouble b) => a.High < b.High || (a.High == b.High && a.Low < b.Low);

    /// <summary>True if the first is larger.</summary>
    public static bool operator >(DoubleDouble a, DoubleDouble b) => b < a;

    /// <summary>True if the first is smaller or equal.</summary>
    public static bool operator <=(DoubleDouble a, DoubleDouble b) => a.High < b.High || (a.High == b.High && a.Low <= b.Low);

    /// <summary>True if the first is larger or equal.</summary>
    public static bool operator >=(DoubleDouble a, DoubleDouble b) => b <= a;

    /// <summary>The exact sum of two doubles in any order (Knuth's two-sum).</summary>
    private static (double Sum, double Error) Sum(double a, double b)
    {
        var sum = a + b;
        var partOfB = sum - a;
        return (sum, a - (sum - partOfB) + (b - partOfB));
    }

    /// <summary>The exact sum of two doubles, the larger one first (Dekker).</summary>
    private static DoubleDouble FastSum(double larger, double smaller)
    {
        var sum = larger + smaller;
        return new(sum, smaller - (sum - larger));
    }

    /// <summary>The exact product of two doubles.</summary>
    private static (double Product, double Error) Product(double a, double b)
    {
        var product = a * b;
        return (product, Math.FusedMultiplyAdd(a, b, -product));
    }

    // Parsing of decimals without loss of digits.

    private const NumberStyles Decimal = NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent;

    /// <summary>The powers of ten that are exact as doubles.</summary>
    private static readonly double[] ExactPowersOfTen = [.. Enumerable.Range(0, 23).Select(k => (double)BigInteger.Pow(10, k))];

    /// <summary>Parses a decimal text. Each of the two parts is correctly rounded, so digits beyond those of a double are kept.</summary>
    /// <param name="text">An optional sign, digits with an optional decimal point, an optional exponent. No blanks or digit groups;
    /// independent of the culture.</param>
    /// <exception cref="FormatException">The text is not such a number, or exceeds the range of <c>double</c>.</exception>
    public static DoubleDouble Parse(ReadOnlySpan<char> text) =>
        TryParse(text, out var value) ? value : throw new FormatException($"'{text}' is not a decimal number within the range of double.");

    /// <summary>Parses a decimal text like <see cref="Parse"/>, without an exception.</summary>
    /// <param name="text">The text.</param>
    /// <param name="value">The number, or zero if the text is not a number.</param>
    /// <returns>True if the text is a number in range.</returns>
    public static bool TryParse(ReadOnlySpan<char> text, out DoubleDouble value)
    {
        value = default;
        if (!double.TryParse(text, Decimal, CultureInfo.InvariantCulture, out var high) || !double.IsFinite(high))
        {
            return false;
        }

        if (TryDigits(text, out var digits, out var places))
        {
            // Digits and power of ten are both exact, and so is the remainder of the rounded quotient. Its own quotient is the low part.
            value = new(high, Math.FusedMultiplyAdd(-high, ExactPowersOfTen[places], digits) / ExactPowersOfTen[places]);
        }
        else if (high != 0)
        {
            var (numerator, denominator) = Fraction(text);
            var (significand, exponent) = Significand(high);
            if (exponent >= 0)
            {
                numerator -= (significand << exponent) * denominator;
            }
            else
            {
                numerator = (numerator << -exponent) - (significand * denominator);
                denominator <<= -exponent;
            }

            value = new(high, Nearest(numerator, denominator));
        }

        return true;
    }

    /// <summary>Reads a short decimal without exponent, as used for coordinates, as an integer that is exact as a double, and the number
    /// of digits after the point.</summary>
    private static bool TryDigits(ReadOnlySpan<char> text, out double digits, out int places)
    {
        const long exact = 1L << 53;
        var (integer, point) = (0L, -1);
        for (var i = 0; i < text.Length; i++)
        {
            if (char.IsAsciiDigit(text[i]))
            {
                integer = Math.Min((10 * integer) + text[i] - '0', exact);
            }
            else if (text[i] == '.')
            {
                point = i;
            }
            else if (text[i] is 'e' or 'E')
            {
                integer = exact;
            }
        }

        places = point < 0 ? 0 : text.Length - point - 1;
        digits = text[0] == '-' ? -integer : integer;
        return integer < exact && places < ExactPowersOfTen.Length;
    }

    /// <summary>The exact value of a well-formed text.</summary>
    private static (BigInteger Numerator, BigInteger Denominator) Fraction(ReadOnlySpan<char> text)
    {
        var mark = text.IndexOfAny('e', 'E');
        var exponent = mark < 0 ? 0 : int.Parse(text[(mark + 1)..], NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture);
        var mantissa = mark < 0 ? text : text[..mark];
        var point = mantissa.IndexOf('.');
        var digits = BigInteger.Parse(
            point < 0 ? mantissa : string.Concat(mantissa[..point], mantissa[(point + 1)..]),
            NumberStyles.AllowLeadingSign,
            CultureInfo.InvariantCulture);
        exponent -= point < 0 ? 0 : mantissa.Length - point - 1;
        return exponent >= 0 ? (digits * BigInteger.Pow(10, exponent), BigInteger.One) : (digits, BigInteger.Pow(10, -exponent));
    }

    /// <summary>A double as an integer times a power of two.</summary>
    private static (BigInteger Significand, int Exponent) Significand(double value)
    {
        var bits = BitConverter.DoubleToInt64Bits(value);
        var biased = (int)((bits >> 52) & 0x7FF);
        var fraction = bits & 0xFFFFFFFFFFFFF;
        BigInteger magnitude = biased == 0 ? fraction : fraction | (1L << 52);
        return (bits < 0 ? -magnitude : magnitude, Math.Max(biased, 1) - 1075);
    }

    private static double Nearest(BigInteger numerator, BigInteger denominator)
    {
        if (numerator.IsZero)
        {
            return 0;
        }

        // A quotient of 62 to 63 bits, whose last bit records any remainder, rounds to 53 bits like the exact fraction.
        var magnitude = BigInteger.Abs(numerator);
        var shift = 62 - (int)(magnitude.GetBitLength() - denominator.GetBitLength());
        var quotient = BigInteger.DivRem(
            shift >= 0 ? magnitude << shift : magnitude, shift >= 0 ? denominator : denominator << -shift, out var remainder);
        var rounded = Math.ScaleB((double)((ulong)quotient | (remainder.IsZero ? 0UL : 1UL)), -shift);
        return numerator.Sign < 0 ? -rounded : rounded;
    }
}
