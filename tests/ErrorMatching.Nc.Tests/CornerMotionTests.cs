namespace ErrorMatching.Nc.Tests;

/// <summary>Corner words: where the rounding or chamfer begins and ends is worked out by hand. Each program begins at the origin.</summary>
public sealed class CornerMotionTests
{
    [Theory]

    // Square corner at (10, 0), radius 2: from (8, 0) to (10, 2) about (8, 2).
    [InlineData("G1 X10. ,R2. F100\nY10.", "L8,0,0 CCW10,2,0@8,2 L10,10,0")]
    [InlineData("G1 X10. ,R2. F100\nY-10.", "L8,0,0 CW10,-2,0@8,-2 L10,-10,0")]
    [InlineData("G1 X10. ,C2. F100\nY10.", "L8,0,0 L10,2,0 L10,10,0")]
    [InlineData("G91 G1 X10. ,C2. F100\nY10.", "L8,0,0 L10,2,0 L10,10,0")]
    [InlineData("G20 G1 X10. ,R1. F10.\nY10.", "L228.6,0,0 CCW254,25.4,0@228.6,25.4 L254,254,0")]

    // From the line y = 0 into the circle of radius 5 about (10, 5), joined at (15, 5) from below:
    // line x = 15 would be tangent, so come in along y = 5. The center lies 1 above the line y = 5 and 5 - 1 from (10, 5): (10 + sqrt(15),
    // 6), the feet at the same x, and on the circle 5/4 as far out.
    [InlineData("G0 Y5.\nG1 X15. ,R1. F100\nG3 X10. Y10. R5.", "R0,5,0 L13.873,5,0 CCW14.8412,6.25,0@13.873,6 CCW10,10,0@10,5")]

    // Two circles of radius 5 about (5, 0) and (11, 0), over the top and down to (8, 4), up and over again:
    // the rounding of radius 1 lies above, 6 from both centers.
    [InlineData("G2 X8. Y4. I5. J0 ,R1. F100\nX16. Y0 I3. J-4.", "CW7.5,4.3301,0@5,0 CCW8.5,4.3301,0@8,5.1962 CW16,0,0@11,0")]

    [InlineData("G1 X10. ,R2. F100\nG91 G28 Z0\nG90 X1.", "L10,0,0 M?,?,? L1,?,?")]
    [InlineData("G1 X10. ,R2. F100\nG81 X20. Z-5. R2.\nG80 Y1.", "L10,0,0 R?,?,2 R20,?,2 L20,?,-5 R20,?,2 L20,1,2")]
    public void Fanuc(string program, string moves) => Assert.Equal(moves, Moves.Of("fanuc", program));

    [Theory]
    [InlineData("G1 X10 RND=2 F100\nY10", "L8,0,0 CCW10,2,0@8,2 L10,10,0")]
    [InlineData("G1 X10 CHR=2 F100\nY10", "L8,0,0 L10,2,0 L10,10,0")]

    // The width of a chamfer across a square corner is its leg times the square root of two.
    [InlineData("G1 X10 CHF=2.82842712 F100\nY10", "L8,0,0 L10,2,0 L10,10,0")]
    [InlineData("R1=2\nG1 X10 RND=R1 F100\nY10", "L8,0,0 CCW10,2,0@8,2 L10,10,0")]
    [InlineData(
        "G1 F100 RNDM=1 X10\nY10\nX0\nRNDM=0 Y5\nX1", "L9,0,0 CCW10,1,0@9,1 L10,9,0 CCW9,10,0@9,9 L1,10,0 CCW0,9,0@1,9 L0,5,0 L1,5,0")]

    // Nothing is inserted where the next motion leaves the plane.
    [InlineData("G1 F100 RNDM=1 X10\nG0 Z50\nX0", "L10,0,0 R10,0,50 R0,0,50")]
    [InlineData("TRANS X100\nG1 X0 Y0 F100\nX10 RND=2\nY10", "L100,0,0 L108,0,0 CCW110,2,0@108,2 L110,10,0")]
    [InlineData("TRANS X100\nG1 X0 Y0 F100\nG1 X10\nCT X15 Y5", "L100,0,0 L110,0,0 CCW115,5,0@110,5")]
    [InlineData("G1 X10 RND=2 F100\nTRANS X5\nY10", "L10,0,0 L?,10,0")]
    [InlineData("SCALE X2 Y2\nG1 X0 Y0 F100\nX10 RND=2\nY10", "L0,0,0 L16,0,0 CCW20,4,0@16,4 L20,20,0")]
    [InlineData("ROT RPL=90\nG1 X0 Y0 F100\nX10 RND=2\nY10", "L0,0,0 L0,8,0 CCW-2,10,0@-2,8 L-10,10,0")]
    [InlineData("MIRROR X0\nG1 X0 Y0 F100\nX10 RND=2\nY10", "L0,0,0 L-8,0,0 CW-10,2,0@-8,2 L-10,10,0")]
    public void Siemens(string program, string moves) => Assert.Equal(moves, Moves.Of("siemens-840d", program));

    [Fact]
    public void Corner_that_cannot_be_followed_is_reported_once_with_the_block_behind_it()
    {
        var path = Bench.Read("G90 G17 G0 X0 Y0 Z0\nG1 X10. ,R20. F100\nY10.\nX0\n", NcDialects.FanucMill);
        var problem = Assert.Single(path.Problems);
        Assert.Equal(("corner-word", 2), (problem.Code, problem.Block));
    }

    [Theory]
    [InlineData("G1 X10. ,R20. F100\nY10.")]
    [InlineData("G1 X10. ,C12. F100\nY10.")]
    [InlineData("G1 X10. ,R2. F100\nG0 Y10.")]
    [InlineData("G1 X10. ,R2. F100\nX20.")]
    [InlineData("G1 X10. ,R2. F100\nX20. Z5.")]
    [InlineData("G1 X10. ,R2. F100\nZ5.")]
    [InlineData("G1 X10. ,R2. F100\nG2 X20. Y0 I9. J0")]
    [InlineData("G1 X10. ,R#1000 F100\nY10.")]
    public void Where_a_corner_cannot_be_followed_the_next_motion_begins_at_an_unknown_place(string program)
    {
        // Too long, straight on, a rapid, a motion out of the plane, a bad arc, a value of the machine.
        // Where it ends is what the program says.
        var path = Bench.Read("G90 G17 G0 X0 Y0 Z0\n" + program + "\n", NcDialects.FanucMill);
        Assert.Contains(path.Problems, p => p is { Code: "corner-word", Block: 2 });
        Assert.Equal((AxisSet.X | AxisSet.Y, new(10, 0, 0)), (path.Motions[2].UnknownStart, path.Motions[1].End));
    }

    [Fact]
    public void Blocks_whose_ends_a_modal_rounding_moves_are_not_displaced()
    {
        const string Program = "G90 G17 G0 X0 Y0 Z0\nG1 F100 RNDM=1\nN10 X10 Y0\nN20 Y10\nN30 X0\nRNDM=0\n";
        Assert.All(
            (string[])["N10", "N20", "N30", "N10..N30"],
            named => Assert.Equal(NcRefusalCodes.CornerWord, Bench.RefusedNormal(Program, 0.1, named, NcDialects.Siemens840D).Code));
    }
}
