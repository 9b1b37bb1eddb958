using System.Text;

namespace ErrorMatching.Nc.Tests;

public class UnknownPlaceTests
{
    [Fact]
    public void What_may_have_moved_the_tool_unseen_keeps_the_increments_behind_it()
    {
        var path = NcInterpreter.Run(
            NcProgram.FromText("G17 G40 G90 G71\nG0 X0 Y0 Z0\nG91\nN40 G1 X5 F100\nNOBODY=1\nG0 Z5\n"), NcDialects.Siemens840D);
        var wish = DisplacementWish.EndsBy(path, [3], new(0.1, 0.2, 0.3));
        var refusal = Rewriter.Apply(path, wish.Result!).Refusal;
        Assert.Equal((NcRefusalCodes.UnknownState, 6), (refusal!.Code, refusal.Place.Line));
    }

    [Fact]
    public void An_increment_from_a_place_that_the_program_does_not_say_is_not_compensated()
    {
        var path = Bench.Read("G17 G40 G90 G21\nG0 X0 Y0 Z0\nG91\nN40 G1 X5 F100\nG55\nG1 Z5\n");
        var wish = DisplacementWish.EndsBy(path, [3], new(0, 0, 0.3));
        Assert.Equal(NcRefusalCodes.UnknownState, Rewriter.Apply(path, wish.Result!).Refusal!.Code);
    }

    [Theory]
    [InlineData("G1 Z5", "G1 Z6")]
    [InlineData("G1 Z5", "G1 Z5 X1")]
    [InlineData("G1 X7", "G1 X7.001")]
    public void A_changed_word_is_found_although_nobody_knows_where_the_motion_is(string word, string tampered)
    {
        const string Program = "G17 G40 G90 G21\nG0 X0 Y0 Z0\nN40 G1 X5 F100\nX9\nG55\nG91\nG1 Z5\nG1 X7\n";
        var path = Bench.Read(Program);
        var wish = DisplacementWish.EndsBy(path, [2], new(0, 0.3, 0)).Result!;
        var rewrite = Rewriter.Apply(path, wish).Result!;
        Assert.True(Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm).Holds);
        var changed = Encoding.ASCII.GetString(rewrite.Program.Bytes.Span).Replace(word, tampered, StringComparison.Ordinal);
        Assert.NotEqual(Encoding.ASCII.GetString(rewrite.Program.Bytes.Span), changed);
        Assert.False(Prover.Check(path, NcProgram.FromText(changed), wish, rewrite.LeastIncrementMm).Holds);
    }
}
