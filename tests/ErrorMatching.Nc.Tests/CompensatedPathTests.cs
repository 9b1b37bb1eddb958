using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>The path of the tool's center under cutter compensation: places that a drawing gives.</summary>
public sealed class CompensatedPathTests
{
    [Fact]
    public void An_inside_corner_is_the_intersection_and_an_outside_corner_an_arc()
    {
        var center = Follow("G41.1 D6 G1 X0\nX10\nY10\nX20\n");
        Assert.Equal(
            [
                (MotionKind.Line, 0, 3), (MotionKind.Line, 7, 3), (MotionKind.Line, 7, 10), (MotionKind.ArcClockwise, 10, 13),
                (MotionKind.Line, 20, 13),
            ],
            Shown(center).Skip(1));
        Assert.Equal([false, false, false, true, false], center.Motions.Skip(1).Select(m => m.IsInserted));
        Assert.Null(center.Refusal);
    }

    [Fact]
    public void A_way_in_at_an_inside_corner_ends_on_the_contour_s_own_path()
    {
        // Both offset lines: y = 3 and x = -3.
        Assert.Equal((MotionKind.Line, -3, 3), Shown(Follow("G41.1 D6 G1 X0\nY10\n")).ElementAt(1));
    }

    [Fact]
    public void An_arc_grows_outside_and_shrinks_inside()
    {
        var outside = Follow("G41.1 D6 G1 X0\nG2 X10 Y-10 J-10\n").Motions[^1];
        var inside = Follow("G41.1 D6 G1 X0\nG3 X10 Y10 J10\n").Motions[^1];
        Assert.Equal(new(13, -10, 5), Rounded(outside.End));
        Assert.Equal(new(7, 10, 5), Rounded(inside.End));
        Assert.Equal((new Point2(0, -10), new Point2(0, 10)), (outside.Center, inside.Center));
    }

    [Fact]
    public void A_line_meets_a_circle_in_an_inside_corner()
    {
        // The line y = 3 and the circle about (10, 0) with the radius 13.
        var met = Follow("G41.1 D6 G1 X0\nG2 X20 Y0 I10\n").Motions[1].End;
        Assert.Equal((10 - Math.Sqrt(160), 3), (met.X, met.Y), Near);
    }

    [Fact]
    public void A_move_of_the_third_axis_follows_the_corner()
    {
        var center = Follow("G41.1 D6 G1 X0\nX10\nZ2\nY10\n");
        Assert.Equal([new(7, 3, 5), new(7, 3, 2), new(7, 10, 2)], center.Motions.Skip(2).Select(m => Rounded(m.End)));
    }

    [Fact]
    public void After_compensation_the_tool_goes_to_the_programmed_place()
    {
        var center = Follow("G41.1 D6 G1 X0\nX10\nG40 G91 X5\nY1\n");
        Assert.Equal([(MotionKind.Line, 15, 0), (MotionKind.Line, 15, 1)], Shown(center).TakeLast(2));
        Assert.Equal([true, true, false, false], center.Motions.Skip(1).Select(m => m.IsCompensated));
    }

    [Theory]
    [InlineData("X10\nY3\nX20\n", null)]
    [InlineData("X10\nY2.99\nX20\n", "compensation-gouge")]
    [InlineData("X10\nY6\nX0\n", null)]
    [InlineData("X10\nY5.99\nX0\n", "compensation-gouge")]
    [InlineData("G3 X3.1 Y3.1 J3.1\n", null)]
    [InlineData("G3 X3 Y3 J3\n", "compensation-gouge")]
    [InlineData("X10\nG54\nX20\n", "compensation-stop")]
    [InlineData("X10\nM6 T2\nX20\n", "compensation-stop")]
    [InlineData("X10\nG18\nX20\n", "compensation-stop")]
    [InlineData("X10\nG41.1 D5\nX20\n", "compensation-stop")]
    [InlineData("X10\nG40\nG2 X20 R5\n", "compensation-entry")]
    [InlineData("X10\nG10 L2 P1 X5\nX20\n", "compensation-unfollowed")]
    public void What_the_tool_cannot_cut_is_refused_at_its_block(string contour, string? code) =>
        Assert.Equal(code, Follow("G41.1 D6 G1 X0\n" + contour).Refusal?.Code);

    [Theory]
    [InlineData("G41.1 D6 G1 X-16.999\nX0\n", null)]
    [InlineData("G41.1 D6 G1 X-17\nX0\n", "compensation-entry")]
    [InlineData("G41.1 D6 G1 Z2\nX0\n", "compensation-entry")]
    [InlineData("G19 G41.1 D6 G1 Y20\n", "compensation-stop")]
    [InlineData("G41 D1 G1 X0\n", "tool-radius-unknown")]
    public void A_way_in_needs_its_length_and_a_radius(string text, string? code) => Assert.Equal(code, Follow(text).Refusal?.Code);

    [Fact]
    public void A_refusal_names_the_block_the_tool_and_what_to_do()
    {
        var refusal = Follow("N10 G41.1 D6 G1 X0\nN20 X10\nN30 Y2\nN40 X20\n").Refusal!;
        Assert.Equal(("N30", 4), (refusal.Place!.Block, refusal.Place.Line));
        Assert.Contains(" 3 mm", refusal.Message, StringComparison.Ordinal);
        Assert.Contains("too short", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_radius_is_that_of_the_number_or_the_one_for_all()
    {
        var table = ToolRadii.OfTable(new Dictionary<int, double> { [2] = 4 }, 1);
        Assert.Equal((4, 1, 1, -2), (Of(2, table), Of(3, table), Of(2, ToolRadii.Of(1)), Of(2, ToolRadii.Of(-2))));

        static double Of(int number, ToolRadii radii) => CompensatedPath.Of(Bench.Read(
            $"G90 G17 G40 G0 X-20 Y0 Z5\nG41 D{number} G1 X0 F100\n", NcDialects.LinuxCnc.With(radii))).Motions[1].End.Y;
    }

    private static CompensatedPath Follow(string text) => CompensatedPath.Of(
        Bench.Read("G21 G17 G40 G90 G91.1 G94 F100 G0 X-20 Y0 Z5\n" + text, NcDialects.LinuxCnc));

    private static IEnumerable<(MotionKind Kind, double X, double Y)> Shown(CompensatedPath center) =>
        center.Motions.Select(m => (m.Kind, Rounded(m.End).X, Rounded(m.End).Y));

    private static Point3 Rounded(Point3 p) => new(Math.Round(p.X, 9) + 0.0, Math.Round(p.Y, 9) + 0.0, p.Z);

    private static bool Near((double X, double Y) a, (double X, double Y) b) => Math.Abs(a.X - b.X) < 1e-9 && Math.Abs(a.Y - b.Y) < 1e-9;
}
