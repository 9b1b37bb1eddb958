namespace ErrorMatching.Nc.Tests;

/// <summary>What sets grbl apart: lines for the control itself, and no macros, calls, cycles and compensation.</summary>
public sealed class GrblTests
{
    [Theory]
    [InlineData("$X\n$$\n$G\n$I\n$N\nX1", "R1,0,0")]
    [InlineData("$J=G91 G20 X10 F100\nX1", "C?,?,? R1,?,?")]
    [InlineData("$H\nX1 Y2", "C?,?,? R1,2,?")]
    [InlineData("G91.1\nG1 X10 F100\nG2 X20 I5", "L10,0,0 CW20,0,0@15,0")]
    [InlineData("G38.2 Z-9 F50\nZ5", "P0,0,-9 P0,0,5")]
    [InlineData("G28.1\nX5\nG28", "R5,0,0 M?,?,?")]
    public void Motions(string program, string moves) => Assert.Equal(moves, Moves.Of("grbl", program));

    [Theory]
    [InlineData("G81 X1 Z-1 R1 F10")]
    [InlineData("G41 X1")]
    [InlineData("M98 P1")]
    [InlineData("M62 P0")]
    [InlineData("#1=3")]
    [InlineData("G0 X[1+2]")]
    [InlineData("IF [1 EQ 1] GOTO 10")]
    [InlineData("G90.1")]
    [InlineData("$100=250")]
    [InlineData("$C")]
    [InlineData("$RST=*")]
    [InlineData("G43 H1")]
    public void What_the_control_refuses_or_a_setting_changes_is_not_understood(string block)
    {
        var path = Bench.Read("G0 G90 X1 Y1 Z1\n" + block + "\nX5\n", NcDialects.Named("grbl"));
        Assert.Contains(path.Problems, p => p.Block == 1);
        Assert.NotEqual(AxisSet.None, path.Motions[^1].UnknownEnd & AxisSet.Y);
    }

    [Fact]
    public void Arcs_agree_as_closely_as_the_control_asks()
    {
        Assert.False(Arc(0.004).Has(MotionFlags.BadArc));
        Assert.True(Arc(0.006).Has(MotionFlags.BadArc));

        static NcMotion Arc(double off) => Bench.Read(
            FormattableString.Invariant($"G0 X0 Y0 Z0\nG2 X{2 + off} Y0 I1 J0 F100\n"), NcDialects.Named("grbl")).Motions[^1];
    }

    [Fact]
    public void A_dollar_sign_is_a_command_to_grbl_only() =>
        Assert.Equal("unknown-word", Bench.Read("G0 X1.\n$X\n", NcDialects.FanucMill).Problems[0].Code);
}
