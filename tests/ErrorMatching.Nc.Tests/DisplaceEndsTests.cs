using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc.Tests;

/// <summary>Moved end points, as section "end points" of the method says; expected words are worked out by hand.</summary>
public sealed class DisplaceEndsTests
{
    private static readonly Vector3 Right = new(0.1, 0, 0);

    [Fact]
    public void Motion_before_stays_and_the_first_motion_in_the_plane_behind_ends_where_it_did()
    {
        var result = Bench.By("G90 G17\nG0 X0. Y0. Z5.\nN10 G1 X10. Y0. F100\nN20 X10. Y10.\nN30 Y20.\nN40 X0. Y20.\n", Right, "N20");
        Assert.Equal("G90 G17\nG0 X0. Y0. Z5.\nN10 G1 X10. Y0. F100\nN20 X10.1 Y10.\nN30 X10. Y20.\nN40 X0. Y20.\n", result);
    }

    [Fact]
    public void Retract_goes_straight_up_and_the_next_motion_in_the_plane_gets_the_words_it_takes()
    {
        var result = Bench.By("G90 G17\nG0 X0. Y0. Z5.\nN10 G1 X10. Y3. F100\nG0 Z5.\nG43 H1 Z50.\nY20.\nX0.\n", new(0.1, 0.2, 0), "N10");
        Assert.Equal("G90 G17\nG0 X0. Y0. Z5.\nN10 G1 X10.1 Y3.2 F100\nG0 Z5.\nG43 H1 Z50.\nX10. Y20.\nX0.\n", result);
    }

    [Fact]
    public void Named_plunge_gains_the_words_of_both_axes()
    {
        var result = Bench.By("G90 G17\nG0 X0. Y0. Z5.\nN10 G1 Z-1. F100\nN20 X10.\n", new(0.1, -0.2, 0), "N10");
        Assert.Equal("G90 G17\nG0 X0. Y0. Z5.\nN10 G1 X0.1 Y-0.2 Z-1. F100\nN20 X10. Y0.\n", result);
    }

    [Fact]
    public void Named_rapids_and_plunges_move_and_third_axis_too()
    {
        var result = Bench.By("G90 G17\nN10 G0 X0. Y0. Z5.\nN20 G1 Z-1. F100\nN30 X10.\nG0 Z5.\n", new(0.1, 0, -0.05), "N10..N30");
        Assert.Equal("G90 G17\nN10 G0 X0.1 Y0. Z4.95\nN20 G1 Z-1.05 F100\nN30 X10.1\nG0 Z5.\n", result);
    }

    [Fact]
    public void Increments_become_differences_and_the_rest_stays()
    {
        var result = Bench.By("G90 G17 G0 X0. Y0. Z5.\nG91\nN10 G1 X10. F100\nN20 Y10.\nN30 X-5.\nN40 Y5.\n", new(0.1, 0.2, 0), "N10..N20");
        Assert.Equal("G90 G17 G0 X0. Y0. Z5.\nG91\nN10 G1 X10.1 Y0.2 F100\nN20 Y10.\nN30 X-5.1 Y-0.2\nN40 Y5.\n", result);
    }

    [Fact]
    public void Arcs_inside_the_run_keep_their_words_even_with_unequal_radii()
    {
        // The radii differ by 0.012 here: not ours to mend.
        var result = Bench.By(
            "G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X15.012 Y5. I0. J5.\nN30 G2 X20. Y10. R5.\nG0 Z5.\n", Right, "N10..N30");
        Assert.Equal("G90 G17\nG0 X0. Y0.\nN10 G1 X10.1 Y0. F100\nN20 G3 X15.112 Y5. I0. J5.\nN30 G2 X20.1 Y10. R5.\nG0 Z5.\n", result);
    }

    [Fact]
    public void Absolute_centers_inside_the_run_move_along()
    {
        var result = Bench.By(
            "G90 G17 G90.1\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. I10. J5.\nG0 Z5.\n", Right, "N10..N20", NcDialects.LinuxCnc);
        Assert.Contains("N20 G3 X15.1 Y5. I10.1 J5.\n", result, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("N10", 0.1, 0)]
    [InlineData("N20", 0, 0.1)]
    public void Border_arc_takes_the_circle_through_its_new_ends_and_its_middle_moved_by_half(string named, double start, double end)
    {
        var path = Bench.Read("G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. I0. J5.\nG0 Z5.\n");
        var wish = DisplacementWish.EndsBy(path, Bench.Blocks(path, named), Right).Result!;
        var now = NcInterpreter.Run(Bench.Rewritten(path, wish).Program, path.Dialect);
        var (was, arc) = (Bench.MotionOf(path, "N20").Arc, Bench.MotionOf(now, "N20"));
        Assert.Equal(new Point2(10 + start, 0), arc.PlaneStart);
        Assert.Equal(new Point2(15 + end, 5), arc.PlaneEnd);
        Assert.Equal(0, arc.Arc.Circle.SignedDistance(was.Middle + new Vector2(0.05, 0)), 0.0012);
        Assert.Equal(0, ArcCenter.Mismatch(arc.PlaneStart, arc.PlaneEnd, arc.Center), 0.001);
    }

    // A quarter of radius 5 whose end moves by 0.1: the circle through (10, 0), its middle (13.535534, 1.464466), moved by half of that,
    // and (15.1, 5) has the radius 5.0863. With 5, the middle would be 0.036 beside that. An end that moves along its circle keeps the
    // radius.
    [Theory]
    [InlineData(0.1, 0, "N20 G3 X15.1 Y5. R5.086")]
    [InlineData(0.001, -0.001, "N20 G3 X15.001 Y4.999 R5.")]
    public void Radius_stays_while_the_whole_arc_is_where_it_is_wanted(double x, double y, string block)
    {
        var result = Bench.By("G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. R5.\nG0 Z5.\n", new(x, y, 0), "N20");
        Assert.Contains(block + "\n", result, StringComparison.Ordinal);
    }

    [Fact]
    public void Radius_becomes_a_center_where_its_decimals_do_not_suffice()
    {
        // Half a turn of diameter 10 stretched to 10.5: the circle through (0, 0), (5.25, 5) and (10.5, 0) is about (5.25, -0.25625). With
        // a radius of 5.257, its middle would be 0.0144 below that.
        var result = Bench.By("G90 G17\nG0 X0. Y0.\nN10 G2 X10. Y0. R5.\nG0 Z5.\n", new(0.5, 0, 0), "N10");
        Assert.Equal("G90 G17\nG0 X0. Y0.\nN10 G2 X10.5 Y0. I5.25 J-0.256\nG0 Z5.\n", result);
    }

    [Fact]
    public void Order_and_repetition_of_blocks_do_not_matter()
    {
        var path = Bench.Read("G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 X10. Y10.\nN30 X0. Y10.\nX0. Y0.\n");
        var (n10, n20, n30) = (2, 3, 4);
        foreach (var wished in (Func<int[], Outcome<DisplacementWish>>[])[
            b => DisplacementWish.EndsBy(path, b, Right), b => DisplacementWish.Normal(path, b, 0.1)])
        {
            var straight = Bench.Rewritten(path, wished([n10, n20, n30]).Result!);
            var mixed = Bench.Rewritten(path, wished([n30, n10, n20, n10]).Result!);
            Assert.Equal(Bench.Text(straight.Program), Bench.Text(mixed.Program));
        }
    }
}
