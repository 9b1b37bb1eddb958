namespace ErrorMatching.Nc.Tests;

/// <summary>What Haas mills have and Fanuc lacks. Places of bolt holes are worked out by hand.</summary>
public sealed class HaasTests
{
    [Theory]

    // A circle of four, radius 5 about the block's place, the first at 90 degrees; L0 drills no hole at the center.
    [InlineData(
        "G99 G81 Z-3. R1. L0\nG70 I5. J90. L4\nG80",
        "R0,5,10 R0,5,1 L0,5,-3 R0,5,1 R-5,0,1 L-5,0,-3 R-5,0,1 R0,-5,1 L0,-5,-3 R0,-5,1 R5,0,1 L5,0,-3 R5,0,1")]
    [InlineData("G99 G70 G81 X1. Y2. Z-3. R1. I5. L2", "R6,2,10 R6,2,1 L6,2,-3 R6,2,1 R-4,2,1 L-4,2,-3 R-4,2,1")]

    // An arc of two, 90 degrees clockwise from hole to hole.
    [InlineData("G98 G81 Z-3. R1. L0\nG71 I5. J90. K-90. L2", "R0,5,10 R0,5,1 L0,5,-3 R0,5,10 R5,0,10 R5,0,1 L5,0,-3 R5,0,10")]

    // A row of three from the block's place, 5 from hole to hole at 90 degrees, and one of two backwards.
    [InlineData(
        "G99 G81 Z-3. R1. L0\nG72 I5. J90. L3",
        "R0,0,1 L0,0,-3 R0,0,1 R0,5,1 L0,5,-3 R0,5,1 R0,10,1 L0,10,-3 R0,10,1")]
    [InlineData("G99 G72 G81 X1. Y2. Z-3. R1. I-5. L2", "R1,2,10 R1,2,1 L1,2,-3 R1,2,1 R-4,2,1 L-4,2,-3 R-4,2,1")]

    // The tool is at one of the holes or at the center, as nobody looked up: X and Y are not known until they are stated.
    [InlineData("G99 G81 Z-3. R1. L0\nG70 I5. L1\nG80\nG0 X7.", "R5,0,10 R5,0,1 L5,0,-3 R5,0,1 R7,?,1")]

    // Not followed: no cycle, an angle that could count thousandths, another plane, pecks that vary.
    [InlineData("G70 I5. J90. L4", "C?,?,?")]
    [InlineData("G99 G81 Z-3. R1. L0\nG70 I5. J90 L4", "C?,?,?")]
    [InlineData("G18\nG99 G81 Y-3. R1. L0\nG70 I5. J90. L4", "C?,?,?")]
    [InlineData("G99 G81 Z-3. R1. L0\nG72 I5. J90 L4", "C?,?,?")]
    [InlineData("G99 G83 X1. Z-3. R1. I2. J.5 K1. F10.\nG80", "C1,0,1")]
    [InlineData("G12 I5. Z-1. D1 F100.\nG0 Z3.\nX1. Y2.", "C?,?,? R?,?,3 R1,2,3")]
    [InlineData("G150 P100 X1. Z-1. I.3 K.01 Q.1 R.1 D1 F10.\nG0 X1.", "C?,?,? R1,?,?")]

    // Modes stay behind a pocket; behind measuring, they do not.
    [InlineData("G47 P0 X1. (ABC)\nX1. Y2. Z3.", "C?,?,? R1,2,3")]
    [InlineData("G154 P3\nX1. Y1. Z1.", "R1,1,1")]
    [InlineData("G103 P1\nG187 P2 E0.02\nX1.", "R1,0,10")]
    [InlineData("M97 P10 L2\nX9.\nM30\nN10 G91 X1.\nG90 M99", "R1,0,10 R2,0,10 R9,0,10")]

    // K is the least peck and does not repeat the cycle.
    [InlineData("G91 G99 G82 X1. Z-5. R-8. K3", "R1,0,10 R1,0,2 L1,0,-3 R1,0,2")]
    public void Motions(string program, string moves) => Assert.Equal("R0,0,10 " + moves, Moves.Of("haas", "Z10.\n" + program));

    [Fact]
    public void Nothing_is_changed_where_measuring_could_have_changed_the_modes()
    {
        var path = Bench.Read("G90 G17 G40 G0 X0. Y0. Z0.\nG37 H1 Z-3.\nX1. Y2. Z3.\nG0 G90 G17 G40 X4.\n", NcDialects.Named("haas"));
        Assert.Equal([true, false], path.Motions.Skip(2).Select(m => m.Has(MotionFlags.UnsureMode)));
    }

    [Fact]
    public void A_jump_on_an_input_of_the_machine_is_refused()
    {
        var refusal = Bench.Read("G0 X0.\nM96 P10 Q18\nX1.\nN10 X2.\nM30\n", NcDialects.Named("haas")).Refusal;
        Assert.Equal(NcRefusalCodes.UnknownCondition, refusal?.Code);
        Assert.Contains("line 2", refusal!.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_pocket_about_a_displaced_place_is_refused()
    {
        const string program = "G90 G17 G40 G0 X0. Y0. Z5.\nN1 G1 X10. F100.\nN2 Y10.\nG12 I5. Z-1. D1\nG0 Z5.\n";
        Assert.Equal(NcRefusalCodes.FrameChange, Bench.RefusedNormal(program, 0.1, "N2", NcDialects.Named("haas")).Code);
    }
}
