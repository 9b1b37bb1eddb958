using System.Globalization;
using System.Numerics;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests.Numbers;

/// <summary>The judge is exact: every operand is a fraction of integers, and every result is compared with the fraction it should
/// be.</summary>
public class DoubleDoubleTests
{
    private static readonly double UnitSquared = Math.ScaleB(1, -106);

    /// <summary>Numbers with a full low part and exponents far apart, of both signs.</summary>
    private static readonly Gen<DoubleDouble> Number =
        Gen.Choose(-2_000_000_000, 2_000_000_000).Three().Zip(Gen.Choose(-60, 60)).Select(n =>
        {
            var ((a, b, c), e) = n;
            return ((DoubleDouble)a + (b * Math.ScaleB(1, -50)) + (c * Math.ScaleB(1, -92))) * Math.ScaleB(1, e);
        });

    [Fact]
    public void Sums_are_right_to_the_proved_bound() =>
        Draw.Law(Number.Two(), p => Error(p.Item1 + p.Item2, Exact(p.Item1) + Exact(p.Item2)) <= 4 * UnitSquared);

    [Fact]
    public void Differences_are_right_to_the_proved_bound() =>
        Draw.Law(Number.Two(), p => Error(p.Item1 - p.Item2, Exact(p.Item1) + (Exact(p.Item2) * new Fraction(-1, 1))) <= 4 * UnitSquared);

    [Fact]
    public void Products_are_right_to_the_proved_bound() =>
        Draw.Law(Number.Two(), p => Error(p.Item1 * p.Item2, Exact(p.Item1) * Exact(p.Item2)) <= 5 * UnitSquared);

    [Fact]
    public void Quotients_are_right_to_the_proved_bound() =>
        Draw.Law(
            Number.Two(), p => p.Item2 == 0 || Error(p.Item1 / p.Item2, Exact(p.Item1) * Exact(p.Item2).Inverse()) <= 15 * UnitSquared);

    [Fact]
    public void Root_squared_is_the_number() =>
        Draw.Law(
            Number,
            n => Error(
                DoubleDouble.Sqrt(DoubleDouble.Abs(n)) * DoubleDouble.Sqrt(DoubleDouble.Abs(n)),
                Exact(DoubleDouble.Abs(n))) <= 20 * UnitSquared);

    [Fact]
    public void Root_of_two_has_its_published_digits() =>
        Assert.True(Error(DoubleDouble.Sqrt(2), Decimal("1.41421356237309504880168872420969807856967")) < 1e-31);

    [Fact]
    public void Roots_of_zero_and_of_negative_numbers_follow_double()
    {
        Assert.Equal(DoubleDouble.Zero, DoubleDouble.Sqrt(0));
        Assert.False(DoubleDouble.Sqrt(-1).IsFinite);
    }

    [Fact]
    public void Order_is_that_of_the_exact_values() =>
        Draw.Law(Number.Two(), p =>
        {
            var sign = (Exact(p.Item1) + (Exact(p.Item2) * new Fraction(-1, 1))).Numerator.Sign;
            return Math.Sign(p.Item1.CompareTo(p.Item2)) == sign && (p.Item1 < p.Item2) == (sign < 0) && (p.Item1 > p.Item2) == (sign > 0)
                && (p.Item1 <= p.Item2) == (sign <= 0) && (p.Item1 >= p.Item2) == (sign >= 0) && (p.Item1 == p.Item2) == (sign == 0);
        });

    [Fact]
    public void Low_part_decides_between_equal_high_parts()
    {
        var more = (DoubleDouble)1 + 1e-20;
        Assert.True(more > 1 && more >= 1 && !(more < 1) && !(more <= 1) && more != DoubleDouble.One);
        Assert.Equal(DoubleDouble.Abs(more), DoubleDouble.Abs(-more));
    }

    [Theory]
    [InlineData("0.1")]
    [InlineData("-6.860120914")]
    [InlineData("3.14159265358979323846264338327950288")]
    [InlineData("0.000000000000000000000000000012345678901234567890123456789e-5")]
    [InlineData("1234567890123456789012345678901234567890")]
    [InlineData("2.5E+12")]
    [InlineData("1e-280")]
    [InlineData("+.5")]
    [InlineData("760.")]
    [InlineData("1e22")]
    [InlineData("9007199254740993")]
    [InlineData("-9007199254740991.5")]
    [InlineData("0.00000000000000000000000001")]
    public void Decimal_is_read_better_than_to_a_part_in_1e30(string text) =>
        Assert.True(Error(DoubleDouble.Parse(text), Decimal(text)) <= UnitSquared);

    [Fact]
    public void Any_decimal_is_read_to_half_a_unit_of_the_low_part() =>
        Draw.Law(Gen.Choose(-2_000_000_000, 2_000_000_000).Zip(Gen.Choose(0, 999_999_999)).Zip(Gen.Choose(-30, 30)), n =>
        {
            var text = string.Create(CultureInfo.InvariantCulture, $"{n.Item1.Item1}.{n.Item1.Item2:000000000}e{n.Item2}");
            return Error(DoubleDouble.Parse(text), Decimal(text)) <= UnitSquared;
        });

    [Fact]
    public void Digit_far_behind_a_tie_still_decides_the_rounding()
    {
        // 1 + 2^-60 (1 + 2^-53 + 2^-120) lies a trace above the middle between two low parts.
        var numerator = (BigInteger.One << 180) + (BigInteger.One << 120) + (BigInteger.One << 67) + 1;
        var digits = (numerator * BigInteger.Pow(5, 180)).ToString(CultureInfo.InvariantCulture);
        Assert.Equal(Math.ScaleB(1 + Math.ScaleB(1, -52), -60), DoubleDouble.Parse($"{digits}e-180").Low);
    }

    [Fact]
    public void Short_decimals_are_read_as_long_ones_are() =>
        Draw.Law(Gen.Choose(-2_000_000_000, 2_000_000_000).Zip(Gen.Choose(0, 9_999_999)), n =>
        {
            var text = string.Create(CultureInfo.InvariantCulture, $"{n.Item1}.{n.Item2:0000000}");
            return DoubleDouble.Parse(text) == DoubleDouble.Parse(text + "e0")
                && Error(DoubleDouble.Parse(text), Decimal(text)) <= UnitSquared;
        });

    [Theory]
    [InlineData("0")]
    [InlineData("-0.000")]
    [InlineData("0e99999999999")]
    [InlineData("1e-99999999999")]
    public void Zero_is_read_as_zero(string text) => Assert.Equal(0, DoubleDouble.Parse(text).ToDouble());

    [Theory]
    [InlineData("")]
    [InlineData("x")]
    [InlineData("1,5")]
    [InlineData("1 000")]
    [InlineData(" 1")]
    [InlineData("1e")]
    [InlineData("NaN")]
    [InlineData("Infinity")]
    [InlineData("1e309")]
    [InlineData("0x10")]
    [InlineData("(1)")]
    public void What_is_no_decimal_in_range_is_refused(string text)
    {
        Assert.False(DoubleDouble.TryParse(text, out _));
        Assert.Throws<FormatException>(() => DoubleDouble.Parse(text));
    }

    [Fact]
    public void Double_goes_in_and_out_unchanged() => Assert.Equal(0.1, ((DoubleDouble)0.1).ToDouble());

    private static Fraction Exact(DoubleDouble value) => Exact(value.High) + Exact(value.Low);

    private static Fraction Exact(double value)
    {
        var exponent = value == 0 ? 0 : Math.ILogB(value) - 52;
        BigInteger significand = (long)Math.ScaleB(value, -exponent);
        return exponent >= 0 ? new(significand << exponent, 1) : new(significand, BigInteger.One << -exponent);
    }

    private static Fraction Decimal(string text)
    {
        var parts = text.TrimStart('+').Split('e', 'E');
        var point = (parts[0] + ".").IndexOf('.', StringComparison.Ordinal);
        var exponent = (
            parts.Length > 1 ? int.Parse(parts[1], CultureInfo.InvariantCulture) : 0) - Math.Max(0, parts[0].Length - point - 1);
        var digits = BigInteger.Parse(parts[0].Replace(".", "", StringComparison.Ordinal), CultureInfo.InvariantCulture);
        return exponent >= 0 ? new(digits * BigInteger.Pow(10, exponent), 1) : new(digits, BigInteger.Pow(10, -exponent));
    }

    /// <summary>Relative error; absolute where the exact value is zero.</summary>
    private static double Error(DoubleDouble actual, Fraction exact)
    {
        var difference = Exact(actual) + (exact * new Fraction(-1, 1));
        var relative = exact.Numerator.IsZero ? difference : difference * exact.Inverse();
        return relative.Numerator.IsZero
            ? 0
            : Math.Exp(BigInteger.Log(BigInteger.Abs(relative.Numerator)) - BigInteger.Log(BigInteger.Abs(relative.Denominator)));
    }

    private sealed record Fraction(BigInteger Numerator, BigInteger Denominator)
    {
        public static Fraction operator +(Fraction a, Fraction b) =>
            new((a.Numerator * b.Denominator) + (b.Numerator * a.Denominator), a.Denominator * b.Denominator);

        public static Fraction operator *(Fraction a, Fraction b) => new(a.Numerator * b.Numerator, a.Denominator * b.Denominator);

        public Fraction Inverse() => new(Denominator, Numerator);
    }
}
