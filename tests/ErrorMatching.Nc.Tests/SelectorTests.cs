namespace ErrorMatching.Nc.Tests;

/// <summary>Blocks are found by number, range and expression, or refused with a reason.</summary>
public sealed class SelectorTests
{
    private const string Program = "%\nN0010 G0 X0\n/N20 G1 X1\n(first) N30 X2\nN40 G02 X3 R5\nX9\nN40.5 X4\nN50 X5\nN50 X6\n";

    [Theory]
    [InlineData("N10", "1")]
    [InlineData("n0010", "1")]
    [InlineData("N20", "2")]
    [InlineData("N30", "3")]
    [InlineData("N40.5", "6")]
    [InlineData("N10..N40", "1 2 3 4")]
    [InlineData("N30..N40.50", "3 4 5 6")]
    [InlineData("N20..N20", "2")]
    [InlineData("/^N[0-9]+ .*\\bG0?2\\b/", "4")]
    [InlineData("/X9/", "5")]
    [InlineData("/^(?!N)X/", "5")]
    public void Blocks_are_found(string selector, string expected) => Assert.Equal(expected, string.Join(' ', Selected(selector).Value!));

    [Fact]
    public void Several_selectors_give_each_block_once_in_order() =>
        Assert.Equal([1, 2, 3], BlockSelector.Select(NcProgram.FromText(Program), [BlockSelector.Parse("N20..N30"), BlockSelector.Parse("N10"), BlockSelector.Parse("/N20/")]).Value!);

    [Theory]
    [InlineData("N999", NcRefusalCodes.BlockNotFound, "N999", 0)]
    [InlineData("N10..N999", NcRefusalCodes.BlockNotFound, "N999", 0)]
    [InlineData("N50", NcRefusalCodes.BlockAmbiguous, "N50", 9)]
    [InlineData("N10..N50", NcRefusalCodes.BlockAmbiguous, "N50", 9)]
    [InlineData("N40..N20", NcRefusalCodes.BlockNotFound, "N20", 3)]
    [InlineData("/Q7/", NcRefusalCodes.BlockNotFound, "", 0)]
    public void What_names_no_block_or_several_is_refused(string selector, string code, string block, int line)
    {
        var refusal = Selected(selector).Refusal!;
        Assert.Equal((code, block, line), (refusal.Code, refusal.Block, refusal.Line));
    }

    [Fact]
    public void Catastrophic_expression_is_stopped()
    {
        // The look-ahead keeps it off the linear engine; the nested quantifier then takes exponential time.
        var program = NcProgram.FromText("N10 " + new string('a', 60) + "!\n");
        var refusal = BlockSelector.Select(program, [BlockSelector.Parse("/(?=N)N10 (a+)+$/")]).Refusal!;
        Assert.Equal((NcRefusalCodes.BlockNotFound, "N10", 1), (refusal.Code, refusal.Block, refusal.Line));
        Assert.Contains("250 ms", refusal.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("")]
    [InlineData("110")]
    [InlineData("X10")]
    [InlineData("N")]
    [InlineData("N10..")]
    [InlineData("..N10")]
    [InlineData("N10-N20")]
    [InlineData("N10 N20")]
    [InlineData("N#1")]
    [InlineData("//")]
    [InlineData("/(/")]
    public void What_is_no_selector_is_an_error(string selector) =>
        Assert.Equal(NcErrorCode.BadSelector, Assert.Throws<NcException>(() => BlockSelector.Parse(selector)).Code);

    private static NcOutcome<int[]> Selected(string selector) => BlockSelector.Select(NcProgram.FromText(Program), [BlockSelector.Parse(selector)]);
}
