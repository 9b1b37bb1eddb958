using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class LabelRangeTests
{
    [Theory]
    [InlineData("5..14", "5 6 7 8 9 10 11 12 13 14")]
    [InlineData("2a", "2a")]
    [InlineData(" 7 ", "7")]
    [InlineData("3..3", "3")]
    [InlineData("P8 .. P11", "P8 P9 P10 P11")]
    [InlineData("P08..P11", "P08 P09 P10 P11")]
    [InlineData("098..101", "098 099 100 101")]
    public void A_range_stands_for_its_labels(string range, string labels) => Assert.Equal(labels.Split(' '), LabelRange.Expand(range));

    [Theory]
    [InlineData("")]
    [InlineData("14..5")]
    [InlineData("a..b")]
    [InlineData("5..")]
    [InlineData("..5")]
    [InlineData("1..2..3")]
    [InlineData("P1..Q2")]
    [InlineData("08..1")]
    [InlineData("1..07")]
    [InlineData("0..100000")]
    [InlineData("1..99999999999999")]
    public void Anything_else_is_named(string range) =>
        Assert.Equal(MeasurementError.BadRange, Assert.Throws<InputException>(() => LabelRange.Expand(range)).Code);
}
