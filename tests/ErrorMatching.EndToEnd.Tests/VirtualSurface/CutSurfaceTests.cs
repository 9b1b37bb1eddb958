namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The referee itself, judged by closed forms.</summary>
public sealed class CutSurfaceTests
{
    [Fact]
    public void Stylus_rests_on_the_cusps_of_a_plane()
    {
        // Over a pass a stylus as large as the tool sinks as far as the tool did: both cusps beside it were cut by the same radius.
        var moves = Enumerable.Range(0, 41).Select(k => new AxisMove(new(-5, (k - 20) * 0.2, 3), new(5, (k - 20) * 0.2, 3), false, false));
        var surface = new CutSurface(moves, 3, MachineError.None);
        var over = surface.Touch(new(0, 0, 8), new(0, 0, 0), 3)!.Value;

        Assert.Equal(3, over.Z, 6);
    }

    [Fact]
    public void Tiny_stylus_feels_the_valley_and_the_cusp()
    {
        var moves = Enumerable.Range(0, 41).Select(k => new AxisMove(new(-5, (k - 20) * 0.2, 3), new(5, (k - 20) * 0.2, 3), false, false));
        var surface = new CutSurface(moves, 3, MachineError.None);
        var cusp = 3 - Math.Sqrt(9 - 0.01);

        Assert.Equal(0.7 + cusp, surface.Touch(new(0, 0.1, 8), new(0, 0.1, 0), 0.7)!.Value.Z, 4);
    }

    [Fact]
    public void Nothing_is_touched_where_nothing_was_cut_near()
        => Assert.Null(
            new CutSurface([new(new(0, 0, 3), new(5, 0, 3), false, false)], 3, MachineError.None).Touch(new(50, 50, 8), new(50, 50, 0), 3));

    [Fact]
    public void Systematic_error_has_the_paper_s_mean_and_spread()
    {
        var machine = MachineError.Systematic(new Random(5));
        var values = (
            from x in Enumerable.Range(0, 26) from y in Enumerable.Range(0, 22) select 1000 * machine.At(new(3 * x, 3 * y, 0)).Z).ToArray();

        Assert.InRange(values.Average(), 14, 16);
        Assert.InRange(Math.Sqrt(values.Sum(v => Math.Pow(v - values.Average(), 2)) / (values.Length - 1)), 5.5, 6.5);
    }

    [Fact]
    public void Words_of_measuring_and_machine_positions_are_understood()
    {
        var moves = StraightProgram.Read(
            "G0 X0 Y0 Z50\nG53 G0 Z-10\nG0 X1 Y2 Z9 ; X5\nMEAS=1 G1 X1 Y2 Z3 F100\nWRITE(NR,\"L\",\"X9\")\nG38.2 Z1.5\nR1=5\nG1 Z9.\n");

        Assert.Equal(
            [
                new AxisMove(new(1, 2, 9), new(1, 2, 3), false, true),
                new(new(1, 2, 3), new(1, 2, 1.5), false, true),
                new(new(1, 2, 1.5), new(1, 2, 9), false, false)],
            moves);
    }
}
