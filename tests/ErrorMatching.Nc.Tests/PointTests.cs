namespace ErrorMatching.Nc.Tests;

/// <summary>Blocks without length: a corner that cut off a short piece leaves one behind,
/// and the program must be displaceable again.</summary>
public sealed class PointTests
{
    [Fact]
    public void Elements_on_both_sides_of_a_block_without_length_meet_in_their_corner() =>
        Assert.Equal(
            "G90 G17\nG0 X0. Y0.1\nG1 Z-1. F100\nN10 X9.9 Y0.1\nN20 X9.9 Y0.1\nN30 X9.9 Y10.\nG0 Z5.",
            Bench.Normal("G90 G17\nG0 X0. Y0.\nG1 Z-1. F100\nN10 X10. Y0.\nN20 X10. Y0.\nN30 X10. Y10.\nG0 Z5.", 0.1, "N10..N30"));

    [Fact]
    public void A_neighbor_behind_a_block_without_length_slides_along_itself() =>
        Assert.Equal(
            "G90 G17\nG0 X0. Y0.1\nG1 Z-1. F100\nN10 X10. Y0.1\nN20 X10. Y0.1\nN30 X10. Y10.\nG0 Z5.",
            Bench.Normal("G90 G17\nG0 X0. Y0.\nG1 Z-1. F100\nN10 X10. Y0.\nN20 X10. Y0.\nN30 X10. Y10.\nG0 Z5.", 0.1, "N10"));

    // A wall at 90 degrees to a polyline of 0.05 mm steps, displaced by 0.12:
    // two steps are cut off, and displaced back the corner is where it was.
    [Fact]
    public void A_corner_that_cut_off_short_pieces_can_be_displaced_again()
    {
        const string Program =
            "G90 G17\nG0 X0. Y0.\nG1 Z-1. F100\nN10 X10. Y0.\nN20 X10. Y0.05\nN30 X10.001 Y0.1\nN40 X10.002 Y0.15\nN50 X10.004 Y5.\nG0 Z5.";
        var path = Bench.Read(Program);
        var once = Bench.Rewritten(path, DisplacementWish.Normal(path, Bench.Blocks(path, "N10..N50"), 0.12).Result!).Program;
        var again = NcInterpreter.Run(once, path.Dialect);
        var back = Bench.Rewritten(again, DisplacementWish.Normal(again, Bench.Blocks(again, "N10..N50"), -0.12).Result!).Program;
        var corner = NcInterpreter.Run(back, path.Dialect).Motions[2].PlaneEnd;
        Assert.InRange(corner.X, 9.997, 10.003);
        Assert.InRange(corner.Y, -0.001, 0.001);
    }
}
