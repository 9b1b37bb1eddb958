namespace ErrorMatching.Nc.Tests;

/// <summary>Canned cycles as the motions that they are made of, worked out by hand. Each program begins at the origin;
/// the tool goes to 10 above it.</summary>
public sealed class CycleMotionTests
{
    [Theory]
    [InlineData("G98 G81 X1. Y1. Z-5. R2.\nX2.\nG80", "R1,1,10 R1,1,2 L1,1,-5 R1,1,10 R2,1,10 R2,1,2 L2,1,-5 R2,1,10")]
    [InlineData("G99 G81 X1. Y1. Z-5. R2.\nX2.", "R1,1,10 R1,1,2 L1,1,-5 R1,1,2 R2,1,2 L2,1,-5 R2,1,2")]
    [InlineData("G99 G81 X1. Z-5. R2.\nG98 X2.", "R1,0,10 R1,0,2 L1,0,-5 R1,0,2 R2,0,2 L2,0,-5 R2,0,10")]
    [InlineData("G99 G82 X1. Z-5. R2. P500", "R1,0,10 R1,0,2 L1,0,-5 R1,0,2")]
    [InlineData("G99 G85 X1. Z-5. R2.", "R1,0,10 R1,0,2 L1,0,-5 L1,0,2")]
    [InlineData("G98 G84 X1. Z-5. R2.", "R1,0,10 R1,0,2 L1,0,-5 L1,0,2 R1,0,10")]
    [InlineData("G99 G86 X1. Z-5. R2.", "R1,0,10 R1,0,2 L1,0,-5 R1,0,2")]

    // Pecks of 3 from 2: -1, -4, -5; between them out to 2 and back to 0.254 above the last depth.
    [InlineData("G99 G83 X1. Z-5. R2. Q3.", "R1,0,10 R1,0,2 L1,0,-1 R1,0,2 R1,0,-0.746 L1,0,-4 R1,0,2 R1,0,-3.746 L1,0,-5 R1,0,2")]
    [InlineData("G99 G73 X1. Z-5. R2. Q3.", "R1,0,10 R1,0,2 L1,0,-1 R1,0,-0.746 L1,0,-4 R1,0,-3.746 L1,0,-5 R1,0,2")]

    // In increments R counts from where the cycle began, Z from R; K or L holes in a row.
    [InlineData("G91 G99 G81 X1. Z-5. R-8. K3", "R1,0,10 R1,0,2 L1,0,-3 R1,0,2 R2,0,2 L2,0,-3 R2,0,2 R3,0,2 L3,0,-3 R3,0,2")]
    [InlineData("G91 G98 G81 X1. Y2. Z-5. R-8. L2", "R1,2,10 R1,2,2 L1,2,-3 R1,2,10 R2,4,10 R2,4,2 L2,4,-3 R2,4,10")]

    // K0 keeps the words for later and drills nothing.
    [InlineData("G99 G81 X1. Z-5. R2. K0\nX2.", "R2,0,10 R2,0,2 L2,0,-5 R2,0,2")]

    // A block with R alone drills as well, and R stays.
    [InlineData("G99 G81 X1. Z-5. R2.\nR3.\nX2.", "R1,0,10 R1,0,2 L1,0,-5 R1,0,2 R1,0,3 L1,0,-5 R1,0,3 R2,0,3 L2,0,-5 R2,0,3")]
    [InlineData("G99 G81 X1. Z-5. R2.\nM8\nG80\nX2.", "R1,0,10 R1,0,2 L1,0,-5 R1,0,2 R2,0,2")]
    [InlineData("G99 G81 X1. Z-5. R2.\nG0 X2.", "R1,0,10 R1,0,2 L1,0,-5 R1,0,2 R2,0,2")]

    // The R plane above the tool: up first.
    [InlineData("Z0\nG98 G81 X1. Z-5. R2.", "R0,0,0 R0,0,2 R1,0,2 L1,0,-5 R1,0,2")]

    // In G18 the drill points along Y, in G19 along X.
    [InlineData("G18 Y10.\nG99 G81 X1. Z1. Y-5. R2. K1", "R0,10,10 R1,10,1 R1,2,1 L1,-5,1 R1,2,1")]
    [InlineData("G19 X10.\nG98 G81 Y1. Z1. X-5. R2.", "R10,0,10 R10,1,1 R2,1,1 L-5,1,1 R10,1,1")]
    [InlineData("G18 Y10.\nG91 G99 G81 X1. Y-5. R-8. K2", "R0,10,10 R1,10,10 R1,2,10 L1,-3,10 R1,2,10 R2,2,10 L2,-3,10 R2,2,10")]

    // Fine boring: to depth, off the wall by Q in a direction that the machine's parameter 5148 says, out, and back over the hole.
    [InlineData("G98 G76 X1. Z-5. R2. Q0.5\nG0 X2.", "R1,0,10 R1,0,2 L1,0,-5 R?,?,-5 R?,?,10 R1,0,10 R2,0,10")]
    [InlineData("G99 G76 X1. Z-5. R2. Q0.5\nX2.", "R1,0,10 R1,0,2 L1,0,-5 R?,?,-5 R?,?,2 R1,0,2 R2,0,2 L2,0,-5 R?,?,-5 R?,?,2 R2,0,2")]

    // Series 15i, parameter 6200#2 = 1 (B-63324EN/03): I and J say how far and which way, at feed, and are modal;
    // in G18 they are K and I, in G19 J and K.
    [InlineData(
        "G99 G76 X1. Z-5. R2. I0.5 J-0.25\nX2.",
        "R1,0,10 R1,0,2 L1,0,-5 L1.5,-0.25,-5 R1.5,-0.25,2 L1,0,2 R2,0,2 L2,0,-5 L2.5,-0.25,-5 R2.5,-0.25,2 L2,0,2")]
    [InlineData("G18 Y10.\nG99 G76 X1. Z1. Y-5. R2. K0.5 I0.25", "R0,10,10 R1,10,1 R1,2,1 L1,-5,1 L1.25,-5,1.5 R1.25,2,1.5 L1,2,1")]
    [InlineData("G18 Y10.\nG99 G76 X1. Z1. Y-5. R2. Q0.5 K1", "R0,10,10 R1,10,1 R1,2,1 L1,-5,1 R?,-5,? R?,2,? R1,2,1")]
    [InlineData(
        "G99 G76 X1. Z-5. R2. I0.5\nX2. Q0.5", "R1,0,10 R1,0,2 L1,0,-5 L1.5,0,-5 R1.5,0,2 L1,0,2 R2,0,2 L2,0,-5 R?,?,-5 R?,?,2 R2,0,2")]

    // Back boring: R is below, where the tool comes back over the hole, and Z above it, where the cut ends;
    // out to where it began, in G99 too.
    [InlineData(
        "G98 G87 X1. Z-5. R-8. Q0.5\nX2.",
        "R1,0,10 R?,?,10 R?,?,-8 R1,0,-8 L1,0,-5 R?,?,-5 R?,?,10 R1,0,10 R2,0,10 R?,?,10 R?,?,-8 R2,0,-8 L2,0,-5 R?,?,-5 R?,?,10 R2,0,10")]
    [InlineData("G99 G87 X1. Z-5. R-8. I0.5\nG0 X2.", "R1,0,10 L1.5,0,10 R1.5,0,-8 L1,0,-8 L1,0,-5 L1.5,0,-5 R1.5,0,10 L1,0,10 R2,0,10")]
    [InlineData("G91 G98 G87 X1. Z3. R-18. Q0.5", "R1,0,10 R?,?,10 R?,?,-8 R1,0,-8 L1,0,-5 R?,?,-5 R?,?,10 R1,0,10")]
    [InlineData("G87 X1. R2.", "C1,0,?")]

    // What is not followed ends over its place: here a hand retracts.
    [InlineData("G99 G88 X1. Z-5. R2. P500", "C1,0,2")]
    [InlineData("G98 G88 X1. Z-5. R2. P500\nX2.", "C1,0,10 C2,0,10")]
    [InlineData("G81 X1. R2.", "C1,0,?")]
    public void Fanuc(string program, string moves) => Assert.Equal("R0,0,10 " + moves, Moves.Of("fanuc", "Z10. F100\n" + program));

    [Theory]
    [InlineData("G98 G81 X1 Y1 Z-5 R2\nX2\nG80", "R1,1,10 R1,1,2 L1,1,-5 R1,1,10 R2,1,10 R2,1,2 L2,1,-5 R2,1,10")]
    [InlineData("G91 G99 G81 X1 Z-5 R-8 L2", "R1,0,10 R1,0,2 L1,0,-3 R1,0,2 R2,0,2 L2,0,-3 R2,0,2")]
    [InlineData("G18 Y10\nG99 G81 X1 Z1 Y-5 R2", "R0,10,10 R1,10,1 R1,2,1 L1,-5,1 R1,2,1")]
    [InlineData("G99 G83 X1 Z-5 R2 Q3", "R1,0,10 R1,0,2 L1,0,-1 R1,0,2 R1,0,-0.746 L1,0,-4 R1,0,2 R1,0,-3.746 L1,0,-5 R1,0,2")]
    public void LinuxCnc(string program, string moves) => Assert.Equal("R0,0,10 " + moves, Moves.Of("linuxcnc", "Z10 F100\n" + program));

    [Theory]

    // Return plane 10, reference plane 0, safety 2, depth -5: rapid to 2, cut to -5, rapid to 10.
    [InlineData("X1\nCYCLE81(10,0,2,-5)", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10")]
    [InlineData("X1\nCYCLE81(10,0,2,,5)", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10")]
    [InlineData("X1\nCYCLE81(10,0,2,-5,5)", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10")]
    [InlineData("X1\nCYCLE81(10,0,2,-5,3)", "R1,0,10 C1,0,10")]
    [InlineData("X1\nCYCLE82(20,,2,-5)", "R1,0,10 C1,0,20")]
    [InlineData("X1\nCYCLE82(20,0,-2,-5,,0.5)", "R1,0,10 R1,0,2 L1,0,-5 R1,0,20")]
    [InlineData("X1\nCYCLE85(10,0,2,-5)", "R1,0,10 R1,0,2 L1,0,-5 L1,0,2 R1,0,10")]
    [InlineData("X1\nCYCLE86(10,0,2,-5,,1,3)", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10")]
    [InlineData("X1\nCYCLE84(10,0,2,-5,,,3,,1.25,0,500,400)", "R1,0,10 R1,0,2 L1,0,-5 L1,0,2 R1,0,10")]
    [InlineData("X1\nCYCLE840(10,0,2,-5,,0,4,3,1,,1.25)", "R1,0,10 R1,0,2 L1,0,-5 L1,0,2 R1,0,10")]
    [InlineData("X1\nCYCLE87(10,0,2,-5,,3)", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10")]
    [InlineData("X1\nCYCLE88(10,0,2,-5,,1,3)", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10")]
    [InlineData("X1\nCYCLE89(10,0,2,-5,,1)", "R1,0,10 R1,0,2 L1,0,-5 L1,0,2 R1,0,10")]

    // Tapping in strokes (the sixteenth argument), along another axis (the thirteenth, the twelfth).
    [InlineData("X1\nCYCLE84(10,0,2,-5,,,3,,1.25,0,500,400,,,,1,1)", "R1,0,10 C1,0,10")]
    [InlineData("X1\nCYCLE84(10,0,2,-5,,,3,,1.25,0,500,400,1)", "R1,0,10 C1,0,10")]
    [InlineData("X1\nCYCLE84(10,0,2,-5,,,3,,1.25,0,500,400,3)", "R1,0,10 R1,0,2 L1,0,-5 L1,0,2 R1,0,10")]
    [InlineData("X1\nCYCLE840(10,0,2,-5,,0,4,3,1,,1.25,2)", "R1,0,10 C1,0,10")]

    // Boring with a lift at the bottom: along X by -1 and up by 1, up to 2, back over the hole on the way to 10.
    [InlineData("X1\nCYCLE86(10,0,2,-5,,1,3,-1,0,1,0)", "R1,0,10 R1,0,2 L1,0,-5 R0,0,-4 R0,0,2 R1,0,10")]
    [InlineData("X1\nCYCLE86(10,0,2,-5,,1,3,-1,0.5)", "R1,0,10 R1,0,2 L1,0,-5 R0,0.5,-5 R0,0.5,2 R1,0,10")]
    [InlineData("X1\nCYCLE86(10,0,2,-5,,1,3,$A_INA[1],0,0)", "R1,0,10 R1,0,2 L1,0,-5 R?,?,? R?,?,2 R1,0,10")]

    // Depth by a diameter, and a plane that is not the active one; the ones of the last argument say which depth counts.
    [InlineData("X1\nCYCLE81(10,0,2,-5,,0,10,1,12)", "R1,0,10 C1,0,10")]
    [InlineData("X1\nCYCLE81(10,0,2,-5,,0,0,2,12)", "R1,0,10 C1,0,10")]
    [InlineData("X1\nCYCLE81(10,0,2,-5,,0,0,1,12)", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10")]
    [InlineData("X1\nCYCLE82(10,0,2,,5,0.6,0,1,11)", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10")]
    [InlineData("X1\nCYCLE82(10,0,2,-5,,0.6,0,1,11)", "R1,0,10 C1,0,10")]
    [InlineData("R5=-5\nX1\nCYCLE81(10,0,2,R5-1)", "R1,0,10 R1,0,2 L1,0,-6 R1,0,10")]
    [InlineData("G70\nX1\nCYCLE81(1,0,0.1,-0.5)", "R25.4,0,10 R25.4,0,2.54 L25.4,0,-12.7 R25.4,0,25.4")]

    // MCALL drills behind every motion until it stands alone.
    [InlineData("MCALL CYCLE81(10,0,2,-5)\nX1\nX2\nMCALL\nX3", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10 R2,0,10 R2,0,2 L2,0,-5 R2,0,10 R3,0,10")]
    [InlineData("R5=-5\nMCALL CYCLE81(10,0,2,R5)\nR5=-9\nX1\nMCALL\nX3", "R1,0,10 R1,0,2 L1,0,-5 R1,0,10 R3,0,10")]
    [InlineData(
        "MCALL CYCLE81(10,0,2,-5)\nHOLES1(0,0,0,10,5,2)\nMCALL\nX1 Y1 Z1",
        "R10,0,10 R10,0,2 L10,0,-5 R10,0,10 R15,0,10 R15,0,2 L15,0,-5 R15,0,10 R1,1,1")]
    [InlineData("POCKET3(10,0,2,-5)\nX1", "C?,?,? R1,?,?")]
    [InlineData("CYCLE90(10,0,2,-5)\nX1", "C?,?,? R1,?,?")]

    // A cycle of the shop's own is called behind every motion too.
    [InlineData("G0 MCALL OURHOLE(5)\nX1\nY1", "R1,?,? C?,?,? R?,1,? C?,?,?")]
    public void Siemens(string program, string moves) => Assert.Equal("R0,0,10 " + moves, Moves.Of("siemens-840d", "Z10 F100\n" + program));
}
