namespace ErrorMatching.EndToEnd.Tests;

public sealed class RefereeInterpreterTests
{
    [Fact]
    public void Modal_words_and_coordinates_stay()
    {
        var moves = RefereeInterpreter.Run(
            "%\nO1 (a comment X9)\nN10 G0 X1. Y2.\nN20 G1 Y5 F500. ; and another X7\n/N30 X-.5\nN40 Z-2.5\nM30\nX99.\n%\n");

        Assert.Equal(["N10", "N20", "N30", "N40"], moves.Select(m => m.Block));
        Assert.Equal([true, false, false, false], moves.Select(m => m.Rapid));
        Assert.Equal(new Spot(-0.5, 5, -2.5), moves[^1].To);
        Assert.Equal(moves[1].To, moves[2].From);
    }

    [Fact]
    public void Incremental_words_add_up()
    {
        var moves = RefereeInterpreter.Run("G0 X10 Y10\nG91 G1 X1.5\nY-2\nG90 X0");

        Assert.Equal([new Spot(10, 10, 0), new Spot(11.5, 10, 0), new Spot(11.5, 8, 0), new Spot(0, 8, 0)], moves.Select(m => m.To));
    }

    [Fact]
    public void Inches_scale_centers_and_radii_too()
    {
        var moves = RefereeInterpreter.Run("G20 G0 X1 Y0\nG3 X0 Y1 I-1 J0\nG2 X1 Y0 R1");

        Assert.Equal(25.4, moves[1].Radius, 12);
        Assert.Equal(new Spot(0, 25.4, 0), moves[1].To);
        Assert.Equal(25.4, moves[2].Radius, 12);
        Assert.Equal(0, moves[2].Center.Length, 12);
    }

    [Theory]
    [InlineData("G3 X0 Y10 R10", 0, 0, 90)]
    [InlineData("G3 X0 Y10 R-10", 10, 10, 270)]
    [InlineData("G2 X0 Y10 R10", 10, 10, -90)]
    [InlineData("G2 X0 Y10 R-10", 0, 0, -270)]
    [InlineData("G3 X0 Y10 I-10 J0", 0, 0, 90)]
    [InlineData("G2 X0 Y10 I-10 J0", 0, 0, -270)]
    [InlineData("G3 I-10", 0, 0, 360)]
    [InlineData("G2 I-10", 0, 0, -360)]
    public void Arc_has_the_center_and_the_sweep_of_its_words(string arc, double centerX, double centerY, double sweepDegrees)
    {
        var move = RefereeInterpreter.Run("G0 X10 Y0\n" + arc)[1];

        Assert.Equal(centerX, move.Center.U, 9);
        Assert.Equal(centerY, move.Center.V, 9);
        Assert.Equal(sweepDegrees, move.Sweep * 180 / Math.PI, 9);
    }

    // ISO 6983-1: each plane is seen against its third axis, so that the counter-clockwise quarter goes from X to Y, from Z to X,
    // from Y to Z.
    [Theory]
    [InlineData("G17 G0 X10\nG3 X0 Y10 I-10")]
    [InlineData("G18 G0 Z10\nG3 Z0 X10 K-10")]
    [InlineData("G19 G0 Y10\nG3 Y0 Z10 J-10")]
    public void Counter_clockwise_quarter_turns_the_first_axis_into_the_second(string program)
    {
        var move = RefereeInterpreter.Run(program)[1];

        Assert.Equal(Math.PI / 2, move.Sweep, 12);
        Assert.Equal(0, move.Center.Length, 12);
        Assert.Equal(new Flat(0, 10), move.To.In(move.Plane));
    }

    [Fact]
    public void Compensation_is_noted_until_it_is_cancelled()
    {
        var moves = RefereeInterpreter.Run("G0 X0\nG41 D1 G1 X1\nX2\nG40 X3\nG42 D1 X4");

        Assert.Equal([CutterSide.None, CutterSide.Left, CutterSide.Left, CutterSide.None, CutterSide.Right], moves.Select(m => m.Side));
    }

    [Theory]
    [InlineData("G1 X5 A10")]
    [InlineData("M98 P100")]
    [InlineData("G81 X5 Z-2 R1")]
    [InlineData("G68 X0 Y0 R45")]
    [InlineData("G92 X0")]
    [InlineData("G1 X#1")]
    [InlineData("G1 X[1+2]")]
    [InlineData("G1 X1 X2")]
    [InlineData("G2 X5")]
    [InlineData("G2 X5 Y0 I2 J0")]
    [InlineData("G2 X5 Y0 R2")]
    [InlineData("G1 X5 R2")]
    [InlineData("G91 G28 X0\nG90 G1 Y5")]
    [InlineData("G1 X5 (no end")]
    public void What_could_move_an_axis_otherwise_is_refused(string program) =>
        Assert.Throws<RefereeException>(() => RefereeInterpreter.Run(program));

    [Fact]
    public void Retract_to_home_at_the_end_needs_no_place()
    {
        var moves = RefereeInterpreter.Run("G0 X1 Y1 Z5\nG1 Z-1\nX2\nG0 Z5\nG91 G28 Z0\nG90\nG4 X2\nG0 X50\nM30");

        Assert.Equal(5, moves.Count);
        Assert.True(double.IsNaN(moves[^1].To.Z));
        Assert.Equal(50, moves[^1].To.X);
    }
}
