namespace ErrorMatching.Nc.Tests;

/// <summary>
/// What the rewriter refuses to change, the proof does not let pass either, by what it knows itself:
/// a changed word says where a motion goes only if nothing else has a say in it.
/// </summary>
public sealed class PlainMotionTests
{
    private const string Head = "G21 G90 G17 G40\nG0 X0. Y0. Z0.\n";

    [Theory]
    [InlineData("N10 G1 X10. E5 F100\n")] // an unknown word
    [InlineData("G68 X0. Y0. R30.\nN10 G1 X10. F100\n")]
    [InlineData("N10 G1 X10. A5. F100\n")]
    [InlineData("G187\nN10 G1 X10. F100\n")] // an unknown code
    [InlineData("N10 G1 X10. Y#500 F100\n")]
    [InlineData("N10 G81 X10. Z-2. R1. F100\nG80\n")]
    [InlineData("N10 G2 X10. Y3. I1. J1. F100\n")] // no circle
    public void A_word_that_is_not_alone_in_saying_where_a_motion_goes_must_not_change(string program)
    {
        var path = Bench.Read(Head + program, NcDialects.FanucMill);
        var motion = path.MotionOf(Bench.Blocks(path, "N10")[0]);
        var result = NcProgram.FromText(Head + program.Replace("X10.", "X10.1", StringComparison.Ordinal));
        var failures = Prover.Check(path, result, DisplacementWish.OfPoints([new(motion, new(0.1, 0, 0))]), 0.001).Failures;

        Assert.Contains(failures, f => f.Message.Contains("its words alone", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("N10 G1 X10. F100\n")]
    [InlineData("N10 G0 X10.\n")]
    [InlineData("N10 G1 X10. Y[2+3] F100\n")]
    [InlineData("G41 D1\nN10 G1 X10. F100\n")]
    [InlineData("N10 G42 D1 G1 X10. F100\n")]
    public void A_plain_motion_may_change(string program)
    {
        var path = Bench.Read(Head + program, NcDialects.FanucMill);
        var motion = path.MotionOf(Bench.Blocks(path, "N10")[0]);
        var result = NcProgram.FromText(Head + program.Replace("X10.", "X10.1", StringComparison.Ordinal));

        Assert.Empty(Prover.Check(path, result, DisplacementWish.OfPoints([new(motion, new(0.1, 0, 0))]), 0.001).Failures);
    }
}
