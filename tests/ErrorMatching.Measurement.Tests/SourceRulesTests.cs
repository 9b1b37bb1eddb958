using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class SourceRulesTests
{
    private static readonly SourceRules Rules = new(
        [SourceRule.OfFileName("^P-[0-9]+"), SourceRule.OfHeaderField("Kind", "^part$")],
        [SourceRule.OfFileName("counter"), SourceRule.OfColumn("piece", "^C")]);

    [Theory]
    [InlineData("dir/P-17.csv", "", "A", SourceSide.Part)]
    [InlineData("C:\\P-1\\x.csv", "kind = part", "A", SourceSide.Part)]
    [InlineData("counter/counter.csv", "", "A", SourceSide.Counterpart)]
    [InlineData("x.csv", "Kind: partly", "C1", SourceSide.Counterpart)]
    public void Name_field_or_column_decide(string file, string field, string piece, SourceSide side) =>
        Assert.Equal(side, Rules.Decide(File(file, field, piece)));

    [Theory]
    [InlineData("x.csv", "", "A")]
    [InlineData("P-1/x.csv", "", "A")]
    [InlineData("counter/x.csv", "Other: part", "AC")]
    public void No_rule_is_an_error_that_lists_them(string name, string field, string piece)
    {
        var error = Assert.Throws<InputException>(() => Rules.Decide(File(name, field, piece)));
        Assert.Equal((MeasurementError.UndecidedSource, name), (error.Code, error.File));
        Assert.Contains(" piece matches /^C/", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Rules_of_both_sides_are_an_error_that_says_which_matched()
    {
        var error = Assert.Throws<InputException>(() => Rules.Decide(File("P-1.csv", "", "C1")));
        Assert.Equal(MeasurementError.ContradictorySource, error.Code);
        Assert.Contains(
            "because the file name matches /^P-[0-9]+/, and the counterpart's, because the column piece matches /^C/;",
            error.Message,
            StringComparison.Ordinal);
        Assert.DoesNotContain("header field", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_column_matches_only_if_all_its_values_do()
    {
        var file = Text.Read("point,x_mm,y_mm,piece\n1,1,2,C1\n2,1,2,D1\n");
        Assert.False(SourceRule.OfColumn("piece", "^C").Matches(file));
        Assert.True(SourceRule.OfColumn("PIECE", "^[CD]").Matches(file));
        Assert.False(SourceRule.OfColumn("none", "").Matches(file));
    }

    [Theory]
    [InlineData("(")]
    [InlineData("(?=a)")]
    [InlineData(@"(a)\1")]
    public void A_pattern_that_cannot_be_used_is_named(string pattern) =>
        Assert.Equal(MeasurementError.BadPattern, Assert.Throws<InputException>(() => SourceRule.OfFileName(pattern)).Code);

    private static MeasurementFile File(string name, string field, string piece) =>
        Text.Read(field + "\npoint,x_mm,y_mm,piece\n1,1,2," + piece + "\n", MeasurementFormat.Points with { SkipLines = 1 }, name);
}
