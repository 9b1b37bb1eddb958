namespace ErrorMatching.Nc.Tests;

/// <summary>Work offsets, shifts and reference points; expected ends are worked out by hand.
/// Each program begins at the origin of G54.</summary>
public sealed class OffsetMotionTests
{
    [Theory]

    // Where nobody says where an offset is, nothing is known behind it but what is stated.
    [InlineData("G55\nX5", "R5,?,?")]
    [InlineData("G54\nG91 X5", "R5,0,0")]
    [InlineData("G55 G91 X5\nG90 Y2", "R?,?,? R?,2,?")]

    // G54 at (100, 50, 0), G55 at (110, 80, -5): the place (0, 0, 0) of G54 is (-10, -30, 5) of G55.
    [InlineData("G10 L2 P1 X100 Y50 Z0 R0\nX0 Y0 Z0\nG10 L2 P2 X110 Y80 Z-5 R0\nG55\nG91 X1 Y1 Z1", "R0,0,0 R-9,-29,6")]
    [InlineData("G10 L2 P1 X100 Y50 Z0 R0\nX0 Y0 Z0\nG10 L2 P2 X110 Y80 R0\nG55\nG91 X1 Y1 Z1", "R0,0,0 R-9,-29,?")]

    // An offset can be turned, and how G55 is turned is the machine's affair where the program does not say it.
    [InlineData("G10 L2 P1 X100 Y50 Z0 R0\nX0 Y0 Z0\nG10 L2 P2 X110 Y80 Z-5\nG55\nG91 X1 Y1 Z1", "R0,0,0 R?,?,6")]

    // A quarter turn: (10, 30) from the new origin back is (30, -10) along its axes.
    [InlineData("G10 L2 P1 X100 Y50 Z0 R0\nX0 Y0 Z0\nG10 L2 P2 X90 Y20 Z0 R90\nG55\nG91 X1", "R0,0,0 R31,-10,0")]

    // P0 is the offset that is active; moving it by 2 makes the place smaller by 2.
    [InlineData("G10 L2 P1 X100 Y50 Z0 R0\nX5 Y5 Z5\nG10 L2 P0 X102\nG91 X0.5", "R5,5,5 R3.5,5,5")]
    [InlineData("X5 Y5\nG10 L2 P1 X100 R0\nG91 Y1", "R5,5,0 R?,?,0")]

    // L20 gives the tool its coordinates.
    [InlineData("X5 Y5\nG10 L20 P1 X1 Y2\nG91 X1 Y1", "R5,5,0 R2,3,0")]
    [InlineData("G10 L2 P1 X100 Y50 Z0 R0\nX5 Y5 Z0\nG10 L20 P2 X1\nG55 G91 X1 Y1", "R5,5,0 R?,?,?")]
    [InlineData("G91\nG10 L20 P0 X1\nX1", "R2,0,0")]
    [InlineData("G10 L2 P1 R30\nX5", "R5,?,0")]

    // G92 names the place where the tool stands.
    [InlineData("X10 Y20\nG92 X1 Y2\nG91 X1 Y1", "R10,20,0 R2,3,0")]
    [InlineData("X10\nG92 X1\nG92.1\nG91 X1", "R10,0,0 R11,0,0")]
    [InlineData("X10\nG92 X1\nG92.2\nG91 X1\nG92.3\nX1", "R10,0,0 R11,0,0 R3,0,0")]
    [InlineData("X10\nG92 X1\nG92.2\nG92.2\nG92.3\nG91 X1", "R10,0,0 R2,0,0")]
    [InlineData("X10\nG92 X1\nG92.1\nG92.3\nG91 X1", "R10,0,0 R11,0,0")]
    [InlineData("X10\nG92.3\nG90 Y1", "R10,0,0 R?,1,?")]
    [InlineData("X10\nG92 X1\nG92 X5\nG92.1\nG91 X1", "R10,0,0 R11,0,0")]

    // G52 shares its place with G92: it sets the shift, G92.2 suspends it.
    [InlineData("X10\nG52 X3\nG91 X1", "R10,0,0 R8,0,0")]
    [InlineData("X10\nG52 X3\nG52 X0\nG91 X1", "R10,0,0 R11,0,0")]
    [InlineData("X10\nG92 X1\nG52 X0\nG91 X1", "R10,0,0 R11,0,0")]
    [InlineData("X10\nG52 X3\nG92.2\nG92.3\nG91 X1", "R10,0,0 R8,0,0")]

    // Machine coordinates are work coordinates where the program has set the offset itself.
    [InlineData("G53 G0 Z0\nG90 X1", "M0,0,? R1,0,?")]
    [InlineData("G10 L2 P1 X100 Y50 Z-200 R0\nX0 Y0 Z0\nG53 G0 Z-10\nG91 Z-1", "R0,0,0 R0,0,190 R0,0,189")]
    [InlineData("G10 L2 P1 X100 Y50 Z-200 R0\nX0 Y0 Z0\nG92 X10\nG53 G0 X0\nG90 Y1", "R0,0,0 R-90,0,0 R-90,1,0")]
    [InlineData("G10 L2 P1 X100 Y50 Z-200 R0\nX0 Y0 Z0\nG43 H1\nG53 G0 Z-10\nX1", "R0,0,0 M0,0,? R1,0,?")]

    // Reference points are reached over the place that the block names.
    [InlineData("X1\nG28 X5 Y6\nX7", "R1,0,0 R5,6,0 M?,?,0 R7,?,0")]
    [InlineData("G91 G28 Z0\nG90 X1", "R0,0,0 M0,0,? R1,0,?")]
    [InlineData("G91 G28 Z5\nG90 X1", "R0,0,5 M0,0,? R1,0,?")]
    [InlineData("G28\nX1 Z2", "R0,0,0 M?,?,? R1,?,2")]
    [InlineData("G1 X5 F100\nG30 Z9\nX7", "L5,0,0 R5,0,9 M5,0,? L7,0,?")]
    public void LinuxCnc(string program, string moves) => Assert.Equal(moves, Moves.Of("linuxcnc", program));

    [Theory]
    [InlineData("G10 L2 P1 X100. Y50. Z0.\nX0 Y0 Z0\nG91 G10 L2 P1 X2.\nX1.", "R0,0,0 R-1,0,0")]
    [InlineData("G90 G10 L2 P1 X100. Y50. Z0.\nX0 Y0 Z0\nG10 L2 P2 X90. Y50. Z0.\nG55\nG91 X1.", "R0,0,0 R11,0,0")]
    [InlineData("G10 L20 P3 X100. Y50. Z0.\nG54.1 P3\nG90 X1. Y1. Z1.\nG10 L20 P4 X110. Y50. Z0.\nG54.1 P4\nG91 X1.", "R1,1,1 R-8,1,1")]
    [InlineData("G10 L2 P0 X5.\nG90 Y1.", "R?,1,?")]
    [InlineData("G10 L10 P1 R5.\nG90 Y1.", "R0,1,0")]

    // G52 lies on top of G92: behind G52 X0 the shift of G92 is still there.
    [InlineData("X10.\nG92 X1.\nG52 X3.\nG91 X1.", "R10,0,0 R-1,0,0")]
    [InlineData("X10.\nG92 X1.\nG52 X3.\nG52 X0.\nG91 X1.", "R10,0,0 R2,0,0")]
    [InlineData("X10.\nG52 X3. Y1.\nG52 X0. Y0.\nG91 X1.", "R10,0,0 R11,0,0")]
    [InlineData("X10.\nG92 S2000\nG91 X1.", "R10,0,0 R11,0,0")]
    [InlineData("G92.1 X0\nG90 Y1.", "R?,?,? R?,1,?")]
    [InlineData("G91 G28 X0 Y0 Z0\nG90 G0 X1. Y2. Z3.", "M?,?,? R1,2,3")]

    // The bottom of a skip move is where the signal came, and the next block is a move of the mode before it.
    [InlineData("G1 F100 Z-1.\nG31 X10.\nY5.", "L0,0,-1 P10,0,-1 L?,5,-1")]
    [InlineData("G4 X5.\nG4 P500\nX1.", "R1,0,0")]
    [InlineData("G22 X100. Y100. Z100. I0. J0. K0.\nG23\nX1.", "R1,0,0")]
    public void Fanuc(string program, string moves) => Assert.Equal(moves, Moves.Of("fanuc", program));

    [Theory]
    [InlineData("G0 SUPA Z100 D0\nX1", "M0,0,? R1,0,?")]
    [InlineData("G153 G0 Z100\nG0 X1 Z2", "M0,0,? R1,0,2")]
    [InlineData("G53 G0 X100\nY1", "M?,0,0 R?,1,0")]
    [InlineData("G74 X1=0 Y1=0\nG0 X1 Y1", "M?,?,? R1,1,?")]
    [InlineData("G75 Z0\nG0 X1", "M0,0,? R1,0,?")]
    [InlineData("G55\nX1 Y1 Z1\nG500\nX2", "R1,1,1 R2,?,?")]
    [InlineData("G507\nX1 Y1 Z1\nG508\nX2", "R1,1,1 R2,?,?")]
    [InlineData("$P_UIFR[1,X,TR]=5\nX2", "R2,?,?")]
    [InlineData("G500\n$TC_DP6[1,1]=3\nX2", "R2,0,0")]
    [InlineData("G25 X0 Y0\nG110 X5 Y5\nX2", "R2,0,0")]
    [InlineData("G1 F100 X1\nMEAS=1 G1 X10\nY5", "L1,0,0 P10,0,0 L?,5,0")]
    [InlineData("X1=10\nY5", "R?,5,?")]
    public void Siemens(string program, string moves) => Assert.Equal(moves, Moves.Of("siemens-840d", program));
}
