namespace ErrorMatching.Nc.Tests;

/// <summary>Polar ends of Siemens programs, worked out by hand.</summary>
public sealed class PolarEndTests
{
    [Theory]

    // About the origin, the tool's place, and the pole before.
    [InlineData("G111 X10 Y20\nG1 AP=0 RP=5 F100\nAP=90 RP=5", "L15,20,0 L10,25,0")]
    [InlineData("G0 X3 Y4\nG110 X10 Y0\nG1 RP=2 AP=90 F100", "R3,4,0 L13,6,0")]
    [InlineData("G111 X10 Y20\nG112 X1 Y1\nG0 AP=180 RP=1", "R10,21,0")]
    [InlineData("R1=90\nG111 X0 Y0\nG1 AP=R1 RP=2*3 Z-1 F100", "L0,6,-1")]
    [InlineData("G18 G111 Z1 X2\nG1 AP=90 RP=3 F100", "L5,0,1")]
    [InlineData("G70 G111 X1 Y0\nG1 AP=0 RP=1 F100", "L50.8,0,0")]

    // A line by its angle and one coordinate: 30 degrees, 10 along X.
    [InlineData("G1 X10 ANG=30 F100", "L10,5.7735,0")]
    [InlineData("G1 Y-10 ANG=-45 F100", "L10,-10,0")]

    // Not followed: no pole, half of an end, increments, an arc, a changed frame or plane, the other way, both coordinates.
    [InlineData("G1 AP=0 RP=5 F100", "L?,?,0")]
    [InlineData("G111 X0 Y0\nG1 AP=0 F100", "L?,?,0")]
    [InlineData("G111 X0 Y0\nG1 AP=IC(10) RP=5 F100", "L?,?,0")]
    [InlineData("G111 X0 Y0\nG91 G1 AP=0 RP=5 Z1 F100", "L?,?,1")]
    [InlineData("G111 X0 Y0\nG0 X5\nG3 AP=90 RP=5 F100", "R5,0,0 CCW?,?,0@5,0")]
    [InlineData("G111 X0 Y0\nTRANS X1\nG1 AP=0 RP=5 F100", "L?,?,0")]
    [InlineData("G111 X0\nG1 AP=0 RP=5 F100", "L?,?,0")]
    [InlineData("G1 X-10 ANG=30 F100", "L?,?,0")]
    [InlineData("G1 X10 ANG=90 F100", "L?,?,0")]
    [InlineData("G1 ANG=90 F100", "L?,?,0")]
    [InlineData("G0 SUPA AP=90 RP=5\nZ1", "R?,?,0 R?,?,1")]
    public void Motions(string program, string moves)
    {
        var path = Bench.Read("G90 G17 G40 G0 X0 Y0 Z0\n" + program + "\n", NcDialects.Siemens840D);
        Assert.Equal(moves, Moves.Of(path, 1));
        Assert.Equal(moves.Contains('?', StringComparison.Ordinal), path.Problems.Count > 0);
    }

    [Fact]
    public void A_polar_end_is_not_changed()
    {
        const string program = "G90 G17 G40 G0 X0 Y0 Z0\nG111 X0 Y0\nN1 G1 AP=0 RP=5 F100\nN2 G1 X9 Y9\n";
        Assert.Equal(NcRefusalCodes.ActiveTransform, Bench.RefusedNormal(program, 0.1, "N1", NcDialects.Siemens840D).Code);
    }
}
