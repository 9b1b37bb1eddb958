namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Modes that a program saves and restores (M70 to M73 of LinuxCNC). What is expected was measured with rs274; random programs are
/// compared with it elsewhere.
/// </summary>
public sealed class SavedModesTests
{
    [Theory]

    // M72 brings back what M70 found, as often as asked.
    [InlineData("M70\nG91\nM72\nG1 X1\nG91\nM72\nG1 X1", "L1,0,0 L1,0,0")]
    [InlineData("M70 G91\nG1 X1\nX1\nM72\nX5", "L1,0,0 L2,0,0 L5,0,0")]
    [InlineData("M73\nG91\nG1 X1\nM72\nX1", "L1,0,0 L1,0,0")]

    // The shift of G92 and the motion mode stay.
    [InlineData("M70\nG1 X1\nG92 X0\nM72\nX1", "L1,0,0 L1,0,0")]
    [InlineData("M70\nG1 X1\nM72\nX2", "L1,0,0 L2,0,0")]
    [InlineData("M70\nG20\nG1 X1\nM72\nX5", "L25.4,0,0 L5,0,0")]
    [InlineData("M70\nG18 G90.1\nG2 X2 Z0 I1 K0\nM72\nG2 X4 Y0 I1 J0", "CW2,0,0@0,1 CW4,0,0@3,0")]

    // What M71 drops, and what another level has saved, cannot be restored: the control stops.
    [InlineData("M70\nM71\nM72\nG1 X1", "L1,?,?")]
    [InlineData("M72\nG1 X1", "L1,?,?")]

    // Words beside M72 can be lost.
    [InlineData("M70\nG91\nM72 G1 X9\nX1", "L9,?,? L1,?,?")]
    [InlineData("M70\nG91\nN5 M72 (WORDS)\nG1 X1", "L1,0,0")]

    // A length that was in force comes back from the table; one that was not is taken out.
    [InlineData("M70\nG43.1 Z5\nG1 Z1\nM72\nZ1", "L0,0,1 L0,0,1")]
    [InlineData("G43.1 Z5\nM70\nG49\nG1 Z1\nM72\nX1", "L0,0,1 L1,0,?")]
    [InlineData("G10 L2 P1 X0 Y0 Z0 R0\nG10 L2 P2 X1 Y0 Z0 R0\nG54\nG0 X0 Y0 Z0\nM70\nG55\nG1 X1\nM72\nY1", "R0,0,0 L1,0,0 L2,1,0")]
    public void Modes_are_restored(string program, string moves) => Assert.Equal(moves, Moves.Of("linuxcnc", "F100\n" + program));

    [Theory]
    [InlineData("M73\nG91", "", "R1,0,0 R1,0,0")]
    [InlineData("M73\nG91\nM71", "", "R1,0,0 R2,0,0")]
    [InlineData("M70\nG91", "", "R1,0,0 R2,0,0")]
    [InlineData("M73\nG91\nM70\nG20", "", "R1,0,0 R2,0,0")]
    [InlineData("M73\nG91\no100 return", "", "R1,0,0 R1,0,0")]
    [InlineData("M72", "M70", "R1,0,0 R1,?,?")]
    public void Modes_of_a_call_are_restored_at_its_end(string body, string before, string moves) => Assert.Equal(
        moves, Of($"o100 sub\n{body}\no100 endsub\nG90 G17 G40 G0 X0 Y0 Z0\nX1\n{before}\no100 call\nX1\n"));

    [Fact]
    public void Each_level_and_each_pass_has_its_own()
    {
        Assert.Equal(
            "R1,0,0 R2,0,0 R1,0,0",
            Of("o1 sub\nM73\nG91\no2 call\nX1\no1 endsub\no2 sub\nM73\nG90 G20\no2 endsub\nG90 G17 G40 G0 X0 Y0 Z0\nX1\no1 call\nX1\n"));
        Assert.Equal(
            "R1,0,0 R4,0,0 R5,0,0 R4,0,0 R5,0,0 R3,0,0",
            Of("G90 G17 G40 G0 X0 Y0 Z0\nX1\nM98 P100 L2\nX3\nM2\nO100\nM73\nX4\nG91\nX1\nM99\n"));
    }

    [Theory]
    [InlineData("o1 call [1] (c) [2] (d) [3] ; e", "L1,2,3")]
    [InlineData("o1 call (c) [1] [2]", "L1,2,0")]
    [InlineData("o1 call [1] [2] ; [3]", "L1,2,0")]
    public void Comments_stand_between_the_arguments_of_a_call(string call, string moves) =>
        Assert.Equal(moves, Moves.Of("linuxcnc", "o1 sub\nG1 X#1 Y#2 Z#3 F1\no1 endsub\n" + call));

    [Theory]
    [InlineData("o1 call [1] [2] X5 [3]")]
    [InlineData("o1 call [1] G1 Y5")]
    [InlineData("o1 call 5 6")]
    [InlineData("o3 if [1] G1 Y5\no3 endif")]
    [InlineData("o3 repeat [2] Y5\no3 endrepeat")]
    public void What_else_stands_behind_a_statement_is_refused(string statement)
    {
        var path = Bench.Read("o1 sub\nG1 X#1 F1\no1 endsub\n" + statement + "\n", NcDialects.LinuxCnc);
        Assert.Equal(NcRefusalCodes.BadExpression, path.Refusal?.Code);
    }

    private static string Of(string program) => Moves.Of(Bench.Read(program, NcDialects.LinuxCnc), 1);
}
