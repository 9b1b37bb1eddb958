using System.Text.RegularExpressions;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>Blocks are found by number, range and expression, or refused with a reason.</summary>
public sealed partial class SelectorTests
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
    [InlineData("L1", "0")]
    [InlineData("L6", "5")]
    [InlineData("l6..L8", "5 6 7")]
    [InlineData("L002..L2", "1")]
    public void Blocks_are_found(string selector, string expected) => Assert.Equal(expected, string.Join(' ', Selected(selector).Result!));

    [Theory]
    [InlineData("L")]
    [InlineData("L0")]
    [InlineData("L-1")]
    [InlineData("L+1")]
    [InlineData("L1.5")]
    [InlineData("L 1")]
    [InlineData("L1..")]
    [InlineData("L1..5")]
    [InlineData("L1..N5")]
    [InlineData("N10..L5")]
    [InlineData("L99999999999")]
    public void What_is_no_line_is_refused(string selector) => Assert.Equal(
        NcInputCodes.BadSelector, Assert.Throws<InputException>(() => BlockSelector.Parse(selector)).Code);

    // On a Siemens control, L2 in a block calls a subprogram. A selector is no word of the program.
    [Fact]
    public void A_line_is_not_the_call_of_a_subprogram()
    {
        var program = NcProgram.FromText("L3\nG1 X1\nX2\nL2\n", NcDialects.Named("siemens-840d").Syntax);
        Assert.Equal([1], BlockSelector.Select(program, [BlockSelector.Parse("L2")]).Result!);
        Assert.Equal([3], BlockSelector.Select(program, [BlockSelector.Parse("/^L2$/")]).Result!);
        Assert.True(BlockSelector.Parse("L2").IsByLine);
        Assert.False(BlockSelector.Parse("N2").IsByLine);
    }

    [Fact]
    public void Lines_are_counted_as_editors_do()
    {
        foreach (var end in (string[])["\n", "\r\n", "\r"])
        {
            var program = NcProgram.FromText($"%{end}{end}(two passes){end}G1 X1{end}G1 X2{end}G1 X1{end}G1 X2");
            Assert.Equal([3, 4, 6], BlockSelector.Select(program, [BlockSelector.Parse("L7"), BlockSelector.Parse("L4..L5")]).Result!);
        }
    }

    [Fact]
    public void Two_passes_with_the_same_text_are_both_meant_and_both_move()
    {
        const string Passes = "G0 X0 Y0\nG1 Z-1 F100\nG1 X10\nG1 Y10\nG0 Z5\nG0 X0 Y0\nG1 Z-2 F100\nG1 X10\nG1 Y10\nG0 Z5\n";
        var path = Bench.Read(Passes);
        var selected = Bench.Blocks(path, "L3..L4", "L8..L9");
        Assert.Equal([2, 3, 7, 8], selected);
        Assert.Equal(
            Passes.Replace("X10", "X10.5", StringComparison.Ordinal),
            Bench.Displaced(path, p => DisplacementWish.EndsBy(p, selected, new(0.5, 0, 0))));
    }

    [Fact]
    public void Several_selectors_give_each_block_once_in_order() =>
        Assert.Equal(
            [1, 2, 3],
            BlockSelector.Select(
                NcProgram.FromText(Program),
                [BlockSelector.Parse("N20..N30"), BlockSelector.Parse("N10"), BlockSelector.Parse("/N20/")]).Result!);

    [Theory]
    [InlineData("N999", NcRefusalCodes.BlockNotFound, "N999", null)]
    [InlineData("N10..N999", NcRefusalCodes.BlockNotFound, "N999", null)]
    [InlineData("N50", NcRefusalCodes.BlockAmbiguous, "N50", 9)]
    [InlineData("N10..N50", NcRefusalCodes.BlockAmbiguous, "N50", 9)]
    [InlineData("N40..N20", NcRefusalCodes.BlockNotFound, "N20", 3)]
    [InlineData("/Q7/", NcRefusalCodes.BlockNotFound, null, null)]
    [InlineData("L11", NcRefusalCodes.BlockNotFound, null, null)]
    [InlineData("L3..L99", NcRefusalCodes.BlockNotFound, null, null)]
    [InlineData("L3..L2", NcRefusalCodes.BlockNotFound, null, null)]
    public void What_names_no_block_or_several_is_refused(string selector, string code, string? block, int? line)
    {
        var refusal = Selected(selector).Refusal!;
        Assert.Equal((code, block, line), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
    }

    [Fact]
    public void An_expression_with_nested_repetition_takes_no_longer_than_any_other()
    {
        // With backtracking this block would take longer than anybody lives.
        var program = NcProgram.FromText("N10 " + new string('a', 200) + "!\nN20 aaa\n");
        Assert.Equal([1], BlockSelector.Select(program, [BlockSelector.Parse("/N[0-9]+ (a+)+$/")]).Result!);
    }

    [Theory]
    [InlineData("/^(?!N)X/", "look-around")]
    [InlineData("/(?=N)N10 (a+)+$/", "look-around")]
    [InlineData("/(N)\\1/", "back references")]
    [InlineData("/((a{90}){90}){90}/", "look-around")]
    public void An_expression_that_must_backtrack_or_is_too_large_is_refused(string selector, string expected)
    {
        var error = Assert.Throws<InputException>(() => BlockSelector.Parse(selector));
        Assert.Equal(NcInputCodes.BadSelector, error.Code);
        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void An_expression_has_at_most_a_thousand_characters()
    {
        Assert.Equal(1002, BlockSelector.Parse($"/{new string('X', BlockSelector.LongestPattern)}/").Text.Length);
        var error = Assert.Throws<InputException>(() => BlockSelector.Parse($"/{new string('X', BlockSelector.LongestPattern + 1)}/"));
        Assert.Contains("1001 characters", error.Message, StringComparison.Ordinal);
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
        Assert.Equal(NcInputCodes.BadSelector, Assert.Throws<InputException>(() => BlockSelector.Parse(selector)).Code);

    [Fact]
    public void No_expression_of_the_system_has_a_limit_by_the_clock() => Assert.All(
        Directory.EnumerateFiles(Repository.PathTo("src"), "*.cs", SearchOption.AllDirectories),
        f => Assert.DoesNotMatch(LimitByTheClock(), File.ReadAllText(f)));

    [GeneratedRegex(
        @"GeneratedRegex\([^\n]*, *[0-9]+\)\]|\bRegex\b[^\n]*TimeSpan\.From|RegexOptions\.[^\n]*TimeSpan\.From|RegexMatchTimeoutException",
        RegexOptions.None,
        Timeout.Infinite)]
    private static partial Regex LimitByTheClock();

    private static Outcome<int[]> Selected(string selector) =>
        BlockSelector.Select(NcProgram.FromText(Program), [BlockSelector.Parse(selector)]);
}
