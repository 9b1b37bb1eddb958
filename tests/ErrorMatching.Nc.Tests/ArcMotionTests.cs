namespace ErrorMatching.Nc.Tests;

/// <summary>All forms of arcs; expected centers and ends are worked out by hand. Each program begins at the origin.</summary>
public sealed class ArcMotionTests
{
    [Theory]

    // Through (5, 5) from (0, 0) to (10, 0): the circle about (5, 0), over the top, so clockwise; under it counter-clockwise.
    [InlineData("CIP X10 Y0 I1=5 J1=5", "CW10,0,0@5,0")]
    [InlineData("CIP X10 Y0 I1=5 J1=-5", "CCW10,0,0@5,0")]
    [InlineData("G91 CIP X10 Y0 I1=5 J1=5", "CW10,0,0@5,0")]
    [InlineData("G0 X10 Y10\nG91 CIP X10 Y0 I1=5 J1=5", "R10,10,0 CW20,10,0@15,10")]
    [InlineData("G0 X10 Y10\nG91 CIP X10 Y0 I1=AC(15) J1=AC(15)", "R10,10,0 CW20,10,0@15,10")]
    [InlineData("G0 X10 Y10\nCIP X20 Y10 I1=IC(5) J1=IC(5)", "R10,10,0 CW20,10,0@15,10")]

    // Past three quarters of the circle about (0, 5): from (0, 0) over (-5, 5) to (5, 5) is clockwise.
    [InlineData("CIP X5 Y5 I1=-5 J1=5", "CW5,5,0@0,5")]

    // Along +X into (10, 0), on to (15, 5): a quarter about (10, 5); to (15, -5) about (10, -5).
    [InlineData("G1 X10 F100\nCT X15 Y5", "L10,0,0 CCW15,5,0@10,5")]
    [InlineData("G1 X10 F100\nCT X15 Y-5", "L10,0,0 CW15,-5,0@10,-5")]
    [InlineData("G1 X10 F100\nCT X15 Y5\nX10 Y10", "L10,0,0 CCW15,5,0@10,5 CCW10,10,0@10,5")]

    // An opening angle with the center gives the end; with the end it gives the center.
    [InlineData("G3 AR=90 I0 J5", "CCW5,5,0@0,5")]
    [InlineData("G2 AR=90 I0 J5", "CW-5,5,0@0,5")]
    [InlineData("G2 AR=270 I0 J5", "CW5,5,0@0,5")]
    [InlineData("G3 X10 Y0 AR=180", "CCW10,0,0@5,0")]
    [InlineData("G3 X10 Y0 AR=90", "CCW10,0,0@5,5")]
    [InlineData("G2 X10 Y0 AR=90", "CW10,0,0@5,-5")]
    [InlineData("G3 X10 Y0 AR=270", "CCW10,0,0@5,-5")]

    // A negative radius is for more than half a turn.
    [InlineData("G2 X10 Y0 CR=5", "CW10,0,0@5,0")]
    [InlineData("G2 X6 Y0 CR=5", "CW6,0,0@3,-4")]
    [InlineData("G2 X6 Y0 CR=-5", "CW6,0,0@3,4")]
    [InlineData("G3 X6 Y0 CR=-5", "CCW6,0,0@3,-4")]
    [InlineData("G91 G3 X6 CR=5", "CCW6,0,0@3,4")]
    [InlineData("G2 X10 Y0 Z-9 I5 J0 TURN=2", "CW10,0,-9@5,0+2")]
    [InlineData("G3 X0 Y0 Z-9 I5 J0 TURN=3", "CCW0,0,-9@5,0+3")]

    // AC() is a position in G91, IC() an increment in G90.
    [InlineData("G0 X10 Y10\nG2 X20 Y10 I=AC(15) J=AC(10)", "R10,10,0 CW20,10,0@15,10")]
    [InlineData("G0 X10 Y10\nG2 X20 Y10 I5 J=AC(10)", "R10,10,0 CW20,10,0@15,10")]
    [InlineData("G0 X10\nG91 G1 X=AC(10) Y5 F100", "R10,0,0 L10,5,0")]
    [InlineData("G0 X10\nG1 X=IC(-2.5) Y5 F100", "R10,0,0 L7.5,5,0")]
    [InlineData("G18\nG2 X=IC(10) K0 I5", "CW10,0,0@0,5")]
    [InlineData("G19\nG2 Y10 J5 K0", "CW0,10,0@5,0")]
    public void Siemens(string program, string moves) => Assert.Equal(moves, Moves.Of("siemens-840d", program));

    [Theory]
    [InlineData("G90.1\nX10 Y0\nG3 X0 Y10 I0 J0 F100", "R10,0,0 CCW0,10,0@0,0")]
    [InlineData("G90.1\nX10 Y5\nG91.1\nG3 X5 Y10 I-5 J0 F100", "R10,5,0 CCW5,10,0@5,5")]
    [InlineData("G2 X10 Y0 Z-9 I5 J0 P3 F100", "CW10,0,-9@5,0+2")]
    [InlineData("G2 X0 Y0 I5 P1 F100", "CW0,0,0@5,0")]
    [InlineData("G20 G2 X1 Y0 I.5 F5", "CW25.4,0,0@12.7,0")]
    [InlineData("G18 G91 G3 X1 Z1 I0 K1 F100", "CCW1,0,1@1,0")]
    public void LinuxCnc(string program, string moves) => Assert.Equal(moves, Moves.Of("linuxcnc", program));

    [Theory]
    [InlineData("siemens-840d", "CIP X10 Y0 I1=5 J1=5 K1=3")]
    [InlineData("siemens-840d", "CIP X10 Y0 Z4 I1=5 J1=5")]
    [InlineData("siemens-840d", "CIP X10 Y0 I1=5")]
    [InlineData("siemens-840d", "CT X10 Y0")]
    [InlineData("siemens-840d", "G1 X10 F100\nCT X20")]
    [InlineData("siemens-840d", "G3 X10 AR=360")]
    [InlineData("siemens-840d", "G2 X10 Y0 CR=4")]
    [InlineData("fanuc", "G2 X10. Y0 R4.")]
    [InlineData("fanuc", "G2 X10. Y0 I4. J0")]
    [InlineData("fanuc", "G2 X10. Y0")]
    public void Arcs_that_are_none_in_a_plane_are_reported(string dialect, string program)
    {
        var path = Bench.Read("G90 G17 G40 G0 X0 Y0 Z0\n" + program + "\n", NcDialects.Named(dialect));
        Assert.Equal("bad-arc", Assert.Single(path.Problems).Code);
        Assert.True(path.Motions[^1].Has(MotionFlags.BadArc));
    }

    [Theory]
    [InlineData("G2 X10. Y0 I5. J#1000")]
    [InlineData("G2 X10. Y0 I#1000 J0")]
    [InlineData("G2 X10. Y0 R#1000")]
    public void Arc_with_a_word_that_only_the_machine_knows_has_no_center(string program)
    {
        var arc = Bench.Read("G90 G17 G40 G0 X0 Y0 Z0\n" + program + "\n", NcDialects.FanucMill).Motions[^1];
        Assert.True(arc.Has(MotionFlags.BadArc) && arc.Has(MotionFlags.Expression));
    }

    [Theory]
    [InlineData("siemens-840d", "G70\nX1\nG1 Y1 F100", 25.4, 100)]
    [InlineData("siemens-840d", "G700\nX1\nG1 Y1 F10", 25.4, 254)]
    [InlineData("siemens-840d", "G700\nG71\nX25.4\nG1 Y1 F10", 25.4, 254)]
    [InlineData("siemens-840d", "G70\nG710\nX25.4\nG1 Y1 F10", 25.4, 10)]
    [InlineData("fanuc", "G20\nX1.\nG1 Y1. F10.", 25.4, 254)]
    [InlineData("linuxcnc", "G20\nX1\nG93 G1 Y1 F10", 25.4, 10)]
    [InlineData("linuxcnc", "G20 G93\nX1\nG94 G1 Y1 F10", 25.4, 254)]
    public void Units_of_lengths_and_feeds(string dialect, string program, double x, double feed)
    {
        var last = Bench.Read("G90 G17 G40 G0 X0 Y0 Z0\n" + program + "\n", NcDialects.Named(dialect)).Motions[^1];
        Assert.Equal((x, feed), (last.End.X, Math.Round(last.Feed, 6)));
    }
}
