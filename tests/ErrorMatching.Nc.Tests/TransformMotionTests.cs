namespace ErrorMatching.Nc.Tests;

/// <summary>Rotation, scale, mirror, polar coordinates and programmable frames; expected ends and centers are worked out by hand. Each
/// program begins at the origin.</summary>
public sealed class TransformMotionTests
{
    [Theory]

    // A quarter turn about the origin takes (10, 0) to (0, 10); about (10, 0) it takes (20, 0) to (10, 10).
    [InlineData("G68 X0 Y0 R90.\nX10. Y0", "R0,10,0")]
    [InlineData("G68 X10. Y0 R90.\nX20. Y0\nG69\nX1. Y1.", "R10,10,0 R1,1,0")]
    [InlineData("G68 X0 Y0 R-90.\nX10. Y0", "R0,-10,0")]

    // Without a center it turns about where the tool stands.
    [InlineData("X10. Y10.\nG68 R90.\nX15. Y10.", "R10,10,0 R10,15,0")]

    // The tool stays where it is; increments are turned, and a coordinate that is not named stays that of the place.
    [InlineData("X10. Y10.\nG68 X0 Y0 R90.\nG91 X1.", "R10,10,0 R10,11,0")]
    [InlineData("X10. Y20.\nG68 X0 Y0 R90.\nX0", "R10,20,0 R10,0,0")]
    [InlineData("G68 X0 Y0 R90.\nG1 X10. Y0 F100\nG2 X20. Y0 I5. J0", "L0,10,0 CW0,20,0@0,15")]
    [InlineData("G18 G68 Z0 X0 R90.\nZ10. X0", "R10,0,0")]
    [InlineData("G18 G68 Z0 X0 R90.\nZ0 X10.", "R0,0,-10")]
    [InlineData("G19 G68 Y0 Z0 R90.\nY10. Z0", "R0,0,10")]
    [InlineData("G68 X0 Y0 R30.\nX10. Y0", "R8.6603,5,0")]

    // P without a point counts thousandths, with one it is the factor.
    [InlineData("G51 X0 Y0 Z0 P2000\nX10. Y5. Z1.", "R20,10,2")]
    [InlineData("G51 X10. Y0 Z0 P2.\nX20. Y5.\nG50\nX1. Y1.", "R30,10,0 R1,1,0")]
    [InlineData("G51 X0 Y0 Z0 I2000 J500 K1000\nX10. Y10. Z10.", "R20,5,10")]

    // A factor of -1 is a mirror: arcs turn the other way under one, and not under two.
    [InlineData("G51 X0 Y0 Z0 I-1000 J1000 K1000\nG1 X0 Y0 F100\nG2 X10. Y0 I5. J0", "L0,0,0 CCW-10,0,0@-5,0")]
    [InlineData("G51 X0 Y0 Z0 I-1000 J-1000 K1000\nG1 X0 Y0 F100\nG2 X10. Y0 I5. J0", "L0,0,0 CW-10,0,0@-5,0")]
    [InlineData("G51 X0 Y0 Z0 P2000\nG1 X0 Y0 F100\nG2 X10. Y0 R5.", "L0,0,0 CW20,0,0@10,0")]
    [InlineData("G51.1 X5.\nX0 Y1.\nG50.1 X0\nX3. Y3.", "R10,1,0 R3,3,0")]
    [InlineData("G51.1 X5.\nG1 X10. Y0 F100\nG3 X0 Y0 R5.", "L0,0,0 CW10,0,0@5,0")]
    [InlineData("G51.1 X5. Y5.\nX0 Y0\nG50.1 X0\nX0 Y0", "R10,10,0 R0,10,0")]
    [InlineData("G51.1 X0 Y0\nG1 X5. Y0 F100\nG3 X0 Y5. R5.", "L-5,0,0 CCW0,-5,0@0,0")]

    // First mirror, then scale, then rotation: (10, 0) is mirrored to (-10, 0), doubled to (-20, 0), turned to (0, -20).
    [InlineData("G51.1 X0\nG51 X0 Y0 Z0 P2000\nG68 X0 Y0 R90.\nX10. Y0", "R0,-20,0")]

    // The center is scaled like every place: (10, 0) is (20, 0), and (20, 0) is (40, 0), a quarter turn about it (20, 20).
    [InlineData("G51 X0 Y0 Z0 P2000\nG68 X10. Y0 R90.\nX10. Y0\nX20.", "R20,0,0 R20,20,0")]
    [InlineData("G68 X0 Y0 R90.\nG51 X0 Y0 Z0 I-1000 J1000 K1000\nG1 X0 Y0 F100\nG2 X10. Y0 I5. J0", "L0,0,0 CCW0,-10,0@0,-5")]

    // A radius about the origin and an angle. In increments the origin would be the place of the tool: not followed.
    [InlineData("G16\nX10. Y30.\nY90.\nG15\nX1. Y1.", "R8.6603,5,0 R0,10,0 R1,1,0")]
    [InlineData("G16 X10. Y180.", "R-10,0,0")]
    [InlineData("G16\nX10. Y30.\nG91 Y30.", "R8.6603,5,0 R?,?,0")]
    [InlineData("G18 G16\nZ10. X90.", "R10,0,0")]
    [InlineData("G19 G16\nY10. Z90.", "R0,0,10")]
    [InlineData("G16\nX10. Y0 Z5.\nZ1.", "R10,0,5 R10,0,1")]

    // What is not followed leaves nothing known behind it.
    [InlineData("G43.4 H1\nG91 X1.\nG49\nX2.", "R?,?,? R?,?,?")]
    [InlineData("G12.1\nG13.1\nG90 X1. Y1. Z1.", "R1,1,1")]
    [InlineData("G51 X0 Y0 Z0 P0\nX5.\nG50\nX6. Y6. Z6.", "R5,?,? R6,6,6")]
    public void Fanuc(string program, string moves) => Assert.Equal(moves, Moves.Of("fanuc", program));

    [Fact]
    public void Scale_that_differs_along_the_axes_makes_a_bad_arc_of_an_arc()
    {
        var path = Bench.Read(
            "G90 G17 G0 X0 Y0 Z0\nG51 X0 Y0 Z0 I2000 J1000 K1000\nG1 X0 Y0 F100\nG2 X10. Y0 I5. J0\n", NcDialects.FanucMill);
        Assert.Equal("bad-arc", Assert.Single(path.Problems).Code);
        Assert.True(path.Motions[^1].Has(MotionFlags.BadArc));
    }

    [Theory]
    [InlineData("TRANS X10 Y20\nX1 Y1\nTRANS\nX1 Y1", "R11,21,0 R1,1,0")]
    [InlineData("TRANS X10\nATRANS X5 Y1\nX1 Y1", "R16,2,0")]
    [InlineData("TRANS X10\nTRANS Y5\nX1 Y1", "R1,6,0")]
    [InlineData("TRANS X10\nG1 X0 Y0 F100\nG2 X10 Y0 I=AC(5) J0", "L10,0,0 CW20,0,0@15,0")]
    [InlineData("ROT RPL=90\nX10 Y0\nROT\nX1 Y1", "R0,10,0 R1,1,0")]
    [InlineData("ROT Z90\nX10 Y0", "R0,10,0")]
    [InlineData("ROT X90\nX0 Y10", "R0,0,10")]
    [InlineData("ROT Y90\nX10 Y0 Z0", "R0,0,-10")]

    // About Z, then about the new X: Y of the program points up.
    [InlineData("ROT Z90 X90\nX10 Y0 Z0\nX0 Y10 Z0\nX0 Y0 Z10", "R0,10,0 R0,0,10 R10,0,0")]
    [InlineData("TRANS X10\nAROT RPL=90\nX5 Y0", "R10,5,0")]
    [InlineData("ROT RPL=90\nATRANS X10\nX5 Y0", "R0,15,0")]
    [InlineData("AROT RPL=45\nAROT RPL=45\nX10 Y0", "R0,10,0")]
    [InlineData("TRANS X10\nROT RPL=90\nX5 Y0", "R0,5,0")]
    [InlineData("G18\nROT RPL=90\nZ10 X0", "R10,0,0")]
    [InlineData("SCALE X2 Y2\nG1 X5 Y0 F100\nG3 X0 Y5 CR=5", "L10,0,0 CCW0,10,0@0,0")]
    [InlineData("SCALE X2\nASCALE X3\nX1", "R6,0,0")]
    [InlineData("MIRROR X0\nG1 X5 Y0 F100\nG3 X0 Y5 CR=5", "L-5,0,0 CW0,5,0@0,0")]
    [InlineData("MIRROR X0 Y0\nG1 X5 Y0 F100\nG3 X0 Y5 CR=5", "L-5,0,0 CCW0,-5,0@0,0")]
    [InlineData("TRANS X10\nAMIRROR X0\nX5 Y1", "R5,1,0")]
    [InlineData("R1=10\nTRANS X=R1 Y=R1*2\nX1 Y1", "R11,21,0")]
    [InlineData("G70\nTRANS X1\nX1", "R50.8,0,0")]
    [InlineData("TRAORI\nG91 X1\nTRAFOOF\nG90 X2 Y2 Z2", "R?,?,? R2,2,2")]
    [InlineData("CYCLE832(0.01,3)\nX1", "R1,0,0")]
    public void Siemens(string program, string moves) => Assert.Equal(moves, Moves.Of("siemens-840d", program));

    [Theory]
    [InlineData("TRANS X10", false)]
    [InlineData("ATRANS X10 Z5", false)]
    [InlineData("ROT RPL=30", true)]
    [InlineData("MIRROR X0", true)]
    [InlineData("SCALE X2", true)]
    [InlineData("TRAORI", true)]
    [InlineData("TRANS X10\nAROT RPL=0", false)]
    public void Shift_alone_does_not_count_as_a_transformation(string block, bool isTransformed)
    {
        var path = Bench.Read($"G90 G17 G40 G0 X0 Y0 Z0\n{block}\nG1 X1 Y1 Z1 F100\n", NcDialects.Siemens840D);
        Assert.Equal(isTransformed, path.Motions[^1].Has(MotionFlags.Transformed));
    }
}
