using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>Exact decimals and the hand that wrote them; <see cref="decimal"/> is the judge.</summary>
public sealed class NumberTests
{
    private static readonly Gen<NcNumber> Numbers = Gen.Choose(-999_999_999, 999_999_999)
        .Zip(Gen.Choose(0, 8))
        .Select(p => new NcNumber(p.Item1, p.Item2));

    [Fact]
    public void Sums_differences_and_texts_are_exact() =>
        Law(Numbers.Two(), p =>
        {
            var (a, b) = (Decimal(p.Item1), Decimal(p.Item2));
            return Decimal(p.Item1 + p.Item2) == a + b
                && Decimal(p.Item1 - p.Item2) == a - b
                && decimal.Parse(p.Item1.ToString(), CultureInfo.InvariantCulture) == a
                && p.Item1.Value == (double)a && p.Item1.SameValue(p.Item2) == (a == b);
        });

    [Fact]
    public void Trimming_and_padding_keep_the_value() =>
        Law(
            Numbers,
            n => Decimal(n.Trim()) == Decimal(n)
                && n.WithDecimals(8).Decimals == 8
                && Decimal(n.WithDecimals(8)) == Decimal(n)
                && (n.Trim().Decimals == 0 || n.Trim().Digits % 10 != 0));

    [Fact]
    public void Rounding_a_double_finds_its_decimal_again() => Law(Numbers, n => NcNumber.Round(n.Value, n.Decimals) == n);

    [Fact]
    public void Numbers_without_room_are_an_error()
    {
        Assert.Equal(NcRefusalCodes.NumberTooLong, Assert.Throws<InputException>(() => NcNumber.Round(1e18, 0)).Code);
        Assert.Equal(NcRefusalCodes.NumberTooLong, Assert.Throws<InputException>(() => NcNumber.Round(double.NaN, 3)).Code);
        Assert.Equal(
            NcRefusalCodes.NumberTooLong,
            Assert.Throws<InputException>(() => new NcNumber(123_456_789_012_345_678, 0).WithDecimals(3)).Code);
    }

    [Theory]
    [InlineData("10.", 5000, "5.")]
    [InlineData("10.", 5100, "5.1")]
    [InlineData("10", 5000, "5")]
    [InlineData("10", 5100, "5.1")]
    [InlineData("10.500", 5100, "5.100")]
    [InlineData("10.500", 5000, "5.000")]
    [InlineData("10.5", 5125, "5.125")]
    [InlineData("+10.5", 5125, "+5.125")]
    [InlineData("+10.5", -5125, "-5.125")]
    [InlineData("-10.5", 5125, "5.125")]
    [InlineData("0.5", 125, "0.125")]
    [InlineData(".5", 125, ".125")]
    [InlineData("-.5", -125, "-.125")]
    [InlineData(".5", 1125, "1.125")]
    [InlineData("007.5", 5125, "005.125")]
    [InlineData("00.500", -5125, "-05.125")]
    [InlineData(".5", 0, "0.")]
    [InlineData("10.123", 5100, "5.1")]
    public void Each_style_keeps_its_hand(string written, int thousandths, string expected) =>
        Assert.Equal(expected, Written(written, thousandths, programIsFixed: false));

    [Fact]
    public void A_program_that_pads_elsewhere_pads_here_too() => Assert.Equal("5.100", Written("10.123", 5100, programIsFixed: true));

    [Fact]
    public void What_is_written_reads_as_the_value() =>
        Law(Numbers.Zip(Gen.Elements("1", "1.", "1.5", "1.50", ".5", "+1.5", "-0.5", "007.500", "+.5")), p =>
        {
            var text = "X" + Encoding.ASCII.GetString(NumberStyle.Of(Encoding.ASCII.GetBytes(p.Item2), false).Format(p.Item1));
            var program = NcProgram.FromText(text);
            foreach (var token in program.Tokens(program[0]))
            {
                return token.Kind == NcTokenKind.Word && token.Length == text.Length && token.Number.SameValue(p.Item1);
            }

            return false;
        });

    private static string Written(string like, int thousandths, bool programIsFixed) =>
        Encoding.ASCII.GetString(NumberStyle.Of(Encoding.ASCII.GetBytes(like), programIsFixed).Format(new(thousandths, 3)));

    private static decimal Decimal(NcNumber n) => n.Digits * new decimal(1, 0, 0, false, (byte)n.Decimals);

    private static void Law<T>(Gen<T> gen, Func<T, bool> law) =>
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(2000), Prop.ForAll(gen.ToArbitrary(), law));
}
