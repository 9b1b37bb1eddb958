using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class LabelRuleTests
{
    private const string Table = "point,x_mm,y_mm\nPNT1,1,2\nPNT2,3,4\n3,5,6\n";

    [Theory]
    [InlineData("PNT{n}", "P07", "PNT7")]
    [InlineData("PNT{n}", "7", "PNT7")]
    [InlineData("{n}_touch", "A10", "10_touch")]
    [InlineData("M {label}", "2a", "M 2a")]
    [InlineData("{n}", "P00", "0")]
    public void A_rule_makes_the_gauges_label(string rule, string label, string name)
    {
        Assert.Equal(name, LabelRule.Parse(rule).Apply(label));
        Assert.Equal(rule, LabelRule.Parse(rule).ToString());
    }

    [Theory]
    [InlineData("")]
    [InlineData("PNT")]
    [InlineData("{n}{n}")]
    [InlineData("{n}{label}")]
    [InlineData("{N}")]
    [InlineData("}{n}")]
    public void A_rule_without_one_place_for_the_label_is_refused(string rule) =>
        Assert.Equal(MeasurementError.BadLabels, Assert.Throws<InputException>(() => LabelRule.Parse(rule)).Code);

    [Fact]
    public void A_file_gets_the_labels_of_the_job()
    {
        var file = Text.Read(Table).Renamed(LabelRule.Parse("PNT{n}"), ["1", "P2"]);
        Assert.Equal((1.0, 3.0), (file["1"].Position.X, file["P2"].Position.X));
        Assert.Equal(3, file.Points.Count);
    }

    // The file's own 3 is not the job's 3, which the gauge would call PNT3.
    [Fact]
    public void A_label_that_is_the_same_by_chance_is_not_meant()
    {
        var error = Assert.Throws<InputException>(() => Text.Read(Table).Renamed(LabelRule.Parse("PNT{n}"), ["1", "3"])["3"]);
        Assert.Equal(MeasurementError.MissingPoint, error.Code);
        Assert.Matches("\"PNT3\" .* 3 .*: \"PNT1\", \"PNT2\", \"3\"", error.Message);
    }

    [Theory]
    [InlineData("PNT{n}", "A1", "B1")]
    [InlineData("PNT{n}", "1", "A")]
    public void Labels_that_a_rule_cannot_tell_apart_are_refused(string rule, string first, string second) => Assert.Equal(
        MeasurementError.BadLabels,
        Assert.Throws<InputException>(() => Text.Read(Table).Renamed(LabelRule.Parse(rule), [first, second])).Code);

    [Fact]
    public void A_missing_point_is_named_with_labels_that_are_there_and_the_rule_that_fits()
    {
        var lines = string.Concat(Enumerable.Range(1, 8).Select(n => $"PNT{n},1,2\n"));
        var error = Assert.Throws<InputException>(() => Text.Read("point,x_mm,y_mm\n" + lines)["1"]);
        Assert.Equal(MeasurementError.MissingPoint, error.Code);
        Assert.Matches(" 8 .*: \"PNT1\", \"PNT2\", \"PNT3\", \"PNT4\", ... \"PNT8\"", error.Message);
        Assert.Contains("write \"labels\": \"PNT{n}\" under \"gauge\"", error.Message, StringComparison.Ordinal);
    }
}
