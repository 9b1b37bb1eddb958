using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Displaced elements: expected words are worked out by hand from the geometry.</summary>
public sealed class DisplaceNormalTests
{
    private const string Head = "G21 G17 G40 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\n";

    [Fact]
    public void Corner_that_turns_left_is_the_intersection_inside_and_the_next_line_slides()
    {
        // Along +X, then +Y, then -X: 0.1 to the left shortens both legs by 0.1; the last line's start slides along itself.
        var result = Bench.Normal(Head + "N10 X10.\nN20 Y10.\nN30 X-5.\n", 0.1, "N10..N20");
        Assert.Equal("G21 G17 G40 G90\nG0 X0 Y0.1 Z5\nG1 Z-1 F100\nN10 X9.9\nN20 Y10.\nN30 X-5.\n", result);
    }

    [Fact]
    public void Corner_that_turns_right_is_the_intersection_outside()
    {
        var result = Bench.Normal(Head + "N10 X10. Y0.\nN20 X10. Y-10.\nN30 X20. Y-10.\n", 0.1, "N10..N20");
        Assert.Equal("G21 G17 G40 G90\nG0 X0 Y0.1 Z5\nG1 Z-1 F100\nN10 X10.1 Y0.1\nN20 X10.1 Y-10.\nN30 X20. Y-10.\n", result);
    }

    [Fact]
    public void Negative_distance_goes_to_the_right_of_travel()
    {
        var result = Bench.Normal(Head + "N10 X10. Y0.\nN20 X10. Y10.\nN30 X0. Y10.\n", -0.1, "N10..N20");
        Assert.Equal("G21 G17 G40 G90\nG0 X0 Y-0.1 Z5\nG1 Z-1 F100\nN10 X10.1 Y-0.1\nN20 X10.1 Y10.\nN30 X0. Y10.\n", result);
    }

    [Theory]
    [InlineData("G3 X10. Y0. I10. J0.", 0.1, "N10 X-10.1 Y0.", "N20 G3 X10.1 Y0. I10.1 J0.")]
    [InlineData("G2 X10. Y0. I10. J0.", 0.1, "N10 X-10.1 Y0.", "N20 G2 X10.1 Y0. I10.1 J0.")]
    [InlineData("G2 X10. Y0. R10.", -0.1, "N10 X-9.9 Y0.", "N20 G2 X9.9 Y0. R9.9")]
    public void Arc_offset_keeps_its_center_and_neighbors_slide_to_it(string arc, double left, string before, string after)
    {
        // A half circle about the origin between two radial lines. Left of a counter-clockwise arc is inside, of a clockwise one outside.
        var sign = arc.StartsWith("G3", StringComparison.Ordinal) ? -left : left;
        var result = Bench.Normal($"G90 G17\nG0 X-20. Y0.\nN10 G1 X-10. Y0. F100\nN20 {arc}\nN30 G1 X20. Y0.\n", sign, "N20").Split('\n');
        Assert.StartsWith(before.Replace("N10 X", "N10 G1 X", StringComparison.Ordinal), result[2], StringComparison.Ordinal);
        Assert.Equal(after, result[3]);
        Assert.Equal("N30 G1 X20. Y0.", result[4]);
    }

    [Fact]
    public void Line_beside_an_arc_meets_the_displaced_circle()
    {
        // The line y = 0 goes to y = 0.1; the circle of radius 5 about (10, 3) shrinks to 4.9 as it is offset to the inside.
        // The line meets it at x = 10 - sqrt(4.9^2 - 2.9^2).
        var path = Bench.Read("G90 G17\nG0 X0. Y0.\nN10 G1 X6. Y0. F100\nN20 G3 X15. Y3. I4. J3.\nN30 G1 X30. Y3.\n");
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N10..N20"), 0.1).Result!;
        var now = NcInterpreter.Run(Bench.Rewritten(path, wish).Program, path.Dialect);
        var corner = Bench.MotionOf(now, "N10").End;
        Assert.Equal(10 - Math.Sqrt((4.9 * 4.9) - (2.9 * 2.9)), corner.X, 0.00051);
        Assert.Equal(0.1, corner.Y, 1e-9);
        Assert.Equal(new Point3(14.9, 3, 0), Bench.MotionOf(now, "N20").End);
    }

    [Fact]
    public void Tangent_line_and_arc_stay_tangent()
    {
        var result = Bench.Normal(
            "G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. I0. J5.\nN30 G1 X15. Y20.\nN40 G0 Z50.\n", 0.25, "N10..N30");
        Assert.Equal(
            "G90 G17\nG0 X0. Y0.25\nN10 G1 X10. Y0.25 F100\nN20 G3 X14.75 Y5. I0. J4.75\nN30 G1 X14.75 Y20.\nN40 G0 Z50.\n", result);
    }

    [Fact]
    public void Fillet_between_flanks_that_move_differently_stays_tangent_to_both()
    {
        var path = Bench.Read("G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. I0. J5.\nN30 G1 X15. Y20.\nN40 X0. Y20.\n");
        var wish = DisplacementWish.OfElements(
            [ElementWish.AlongNormals(path, 1, 0.1, 0.1, 0.1), ElementWish.AlongNormals(path, 3, 0.3, 0.3, 0.3)]);
        var rewrite = Bench.Rewritten(path, wish);

        // Flanks y = 0.1 and x = 14.7; the radius shrinks by the mean of 0.1 and 0.3 to 4.8, so the center is (9.9, 4.9).
        Assert.Equal(
            "G90 G17\nG0 X0. Y0.1\nN10 G1 X9.9 Y0.1 F100\nN20 G3 X14.7 Y4.9 I0. J4.8\nN30 G1 X14.7 Y20.\nN40 X0. Y20.\n",
            Bench.Text(rewrite.Program));
        var proof = Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm);
        Assert.Equal(
            [("line 2", NeighborRole.Positioning), ("N20", NeighborRole.Fillet), ("N40", NeighborRole.Slides)],
            proof.Neighbors.Select(n => (n.Block, n.Role)));
    }

    // Both touch the flanks y = 0.1 and x = 14.7 of the test above, but the radius that was asked for is 4.8.
    [Theory]
    [InlineData("X10. Y0.1", "X14.7 Y4.8 I0. J4.7")]
    [InlineData("X9.89 Y0.1", "X14.7 Y4.91 I0. J4.81")]
    public void A_fillet_of_another_radius_than_was_asked_for_is_not_proved(string start, string arc)
    {
        var path = Bench.Read("G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. I0. J5.\nN30 G1 X15. Y20.\nN40 X0. Y20.\n");
        var wish = DisplacementWish.OfElements(
            [ElementWish.AlongNormals(path, 1, 0.1, 0.1, 0.1), ElementWish.AlongNormals(path, 3, 0.3, 0.3, 0.3)]);
        var program = NcProgram.FromText($"G90 G17\nG0 X0. Y0.1\nN10 G1 {start} F100\nN20 G3 {arc}\nN30 G1 X14.7 Y20.\nN40 X0. Y20.\n");

        var failure = Assert.Single(Prover.Check(path, program, wish, 0.001).Failures.DistinctBy(f => f.Place.Block));
        Assert.Equal("N20", failure.Place.Block);
    }

    [Fact]
    public void Arc_that_would_shrink_to_nothing_is_refused()
    {
        var refusal = Bench.RefusedNormal(
            "G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X10.2 Y0.2 I0. J0.2\nN30 G1 X10.2 Y20.\n", 0.25, "N10..N30");
        Assert.Equal((NcRefusalCodes.ElementFlips, "N20", 4), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
    }

    [Fact]
    public void Short_element_that_would_turn_round_is_refused()
    {
        // A step of 0.1 between two walls: displaced to the left by 0.2 the step would run backwards.
        var refusal = Bench.RefusedNormal("G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 X10. Y0.1\nN30 X9. Y0.1\n", 0.2, "N10..N30");
        Assert.Equal((NcRefusalCodes.ElementFlips, "N20"), (refusal.Code, refusal.Place.Block));
    }

    [Fact]
    public void Short_arc_that_would_turn_round_is_refused()
    {
        // Two degrees of a circle of 5 about (10, 5), tangent to N10; N30, displaced by 0.3, passes at x = 9.874, before the arc begins.
        var refusal = Bench.RefusedNormal(
            "G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X10.174 Y0.003 I0. J5.\nN30 G1 X10.174 Y10.\n", 0.3, "N10..N30");
        Assert.Equal((NcRefusalCodes.ElementFlips, "N20"), (refusal.Code, refusal.Place.Block));
    }

    [Fact]
    public void Of_two_crossings_nearby_the_one_at_the_corner_is_taken()
    {
        // The line y = 0 meets the circle of 1 about (0, -0.966) at 15 degrees, so both crossings are near:
        // 0.05 to the right they are at x = -0.2523 and 0.2523.
        var result = Bench.Normal(
            "G90 G17\nG0 X-5. Y0. Z0.\nN10 G1 X-0.259 Y0. F100\nN20 G2 X1. Y-0.966 I0.259 J-0.966\nG0 Z5.\n", -0.05, "N10..N20");
        Assert.Contains("N10 G1 X-0.252 Y-0.05 F100\n", result, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("N10..N40", "G0 X0.1 Y0.1\nG1 Z-1. F100\nN10 X9.9 Y0.1\nN20 X9.9 Y9.9\nN30 X0.1 Y9.9\nN40 X0.1 Y0.1\nG0 Z5.\nX50. Y50.")]
    [InlineData("N10", "G0 X0. Y0.1\nG1 Z-1. F100\nN10 X10. Y0.1\nN20 X10. Y10.\nN30 X0. Y10.\nN40 X0. Y0.1\nG0 Z5.\nX50. Y50.")]
    [InlineData("N40", "G0 X0.1 Y0.\nG1 Z-1. F100\nN10 X10. Y0.\nN20 X10. Y10.\nN30 X0.1 Y10.\nN40 X0.1 Y0.\nG0 Z5.\nX50. Y50.")]
    public void Closed_contour_stays_closed_whichever_part_is_named(string named, string expected)
    {
        const string Contour = "G0 X0. Y0.\nG1 Z-1. F100\nN10 X10. Y0.\nN20 X10. Y10.\nN30 X0. Y10.\nN40 X0. Y0.\nG0 Z5.\nX50. Y50.";
        Assert.Equal("G90 G17\n" + expected, Bench.Normal("G90 G17\n" + Contour, 0.1, named));
    }

    // The contour is all there is: its corner is the end of the last motion and the start of the first in the plane.
    [Fact]
    public void Last_element_of_a_program_slides_to_the_first_of_its_contour() =>
        Assert.Equal(
            "G90 G17\nG0 X0.1 Y0.\nN10 G1 X10. Y0. F100\nN20 X10. Y10.\nN30 X0.1 Y10.\nN40 X0.1 Y0.",
            Bench.Normal("G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 X10. Y10.\nN30 X0. Y10.\nN40 X0. Y0.", 0.1, "N40"));

    [Fact]
    public void Contour_that_closes_tangentially_stays_closed_if_only_its_first_half_is_named()
    {
        var path = Bench.Read("G90 G17\nG0 X10. Y0.\nN10 G3 X-10. Y0. I-10. J0. F100\nN20 X10. Y0. I10. J0.\nN30 G0 Z5.\n");
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N10"), 0.1).Result!;
        var now = NcInterpreter.Run(Bench.Rewritten(path, wish).Program, path.Dialect);
        Assert.Equal(new Point3(9.9, 0, 0), Bench.MotionOf(now, "N10").Start);
        Assert.Equal(new Point3(9.9, 0, 0), Bench.MotionOf(now, "N20").End);
    }

    [Fact]
    public void Tangential_lead_in_and_lead_out_arcs_follow_a_closed_contour()
    {
        const string Program = "G90 G17\nG0 X5. Y-8.\nG1 Z-1. F100\nN5 G3 X10. Y-3. I0. J5.\nN10 G1 X10. Y10.\nN20 X0. Y10.\nN30 X0. "
            + "Y-3.\nN40 X10. Y-3.\nN50 G3 X5. Y2. I-5. J0.\nG0 Z5.\n";
        var path = Bench.Read(Program);
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N10..N40"), 0.1).Result!;
        var rewrite = Bench.Rewritten(path, wish);
        var now = NcInterpreter.Run(rewrite.Program, path.Dialect);
        Assert.Equal((9.9, -2.9), (Bench.MotionOf(now, "N40").End.X, Bench.MotionOf(now, "N40").End.Y));
        var lead = Bench.MotionOf(now, "N5").Arc;
        Assert.Equal(0, lead.Circle.SignedDistance(Bench.MotionOf(path, "N5").Arc.Middle + new Vector2(-0.05, 0.05)), 0.0016);
        Assert.Equal(
            ["N5", "N50"],
            Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm).Neighbors
                .Where(n => n.Role == NeighborRole.Follows)
                .Select(n => n.Block));
    }

    [Fact]
    public void Rapid_plunge_and_retract_follow_the_border()
    {
        const string Program = "G90 G17\nG0 X0. Y0.\nG0 Z2.\nG1 Z-1. F100\nN10 X10.\nG0 Z2.\nG91 G28 Z0\nG90 G0 X50. Y50.\n";
        Assert.Equal(
            "G90 G17\nG0 X0. Y0.1\nG0 Z2.\nG1 Z-1. F100\nN10 X10.\nG0 Z2.\nG91 G28 Z0\nG90 G0 X50. Y50.\n",
            Bench.Normal(Program, 0.1, "N10"));
    }

    [Fact]
    public void Increments_behind_a_retract_to_the_reference_return_to_the_old_place()
    {
        const string Program = "G90 G17\nG0 X0. Y0.\nG1 Z-1. F100\nN10 X10. Y0.\nG91 G28 Z0.\nG0 X5. Y5.\n";
        Assert.Equal("G90 G17\nG0 X0. Y0.1\nG1 Z-1. F100\nN10 X10. Y0.1\nG91 G28 Z0.\nG0 X5. Y4.9\n", Bench.Normal(Program, 0.1, "N10"));
    }

    [Fact]
    public void Full_circle_changes_its_radius_and_stays_closed_beside_an_oblique_lead_in()
    {
        const string Program = "G90 G17\nG0 X20. Y10.\nN10 G1 X10. Y0. F100\nN20 G3 I-10.\nN30 G1 X20. Y-10.\n";
        Assert.Equal("G90 G17\nG0 X20. Y10.\nN10 G1 X9.9 Y0. F100\nN20 G3 I-9.9\nN30 G1 X20. Y-10.\n", Bench.Normal(Program, 0.1, "N20"));
    }

    [Theory]
    [InlineData(
        "G18",
        "G0 Z0. X0.\nN10 G1 Z10. X0. F100\nN20 G3 Z15. X5. K0. I5.\nN30 G1 Z15. X20.\n",
        "G0 Z0. X0.25\nN10 G1 Z10. X0.25 F100\nN20 G3 Z14.75 X5. K0. I4.75\nN30 G1 Z14.75 X20.\n")]
    [InlineData(
        "G19",
        "G0 Y0. Z0.\nN10 G1 Y10. Z0. F100\nN20 G3 Y15. Z5. J0. K5.\nN30 G1 Y15. Z20.\n",
        "G0 Y0. Z0.25\nN10 G1 Y10. Z0.25 F100\nN20 G3 Y14.75 Z5. J0. K4.75\nN30 G1 Y14.75 Z20.\n")]
    public void Other_planes_turn_as_seen_against_their_third_axis(string plane, string before, string after) =>
        Assert.Equal("G90 " + plane + "\n" + after, Bench.Normal("G90 " + plane + "\n" + before, 0.25, "N10..N30"));

    [Fact]
    public void Ten_thousand_increments_keep_their_sum()
    {
        var text = "G91 G17 G21\nG0 G90 X0. Y0.\nG1 G91 F100\n"
            + string.Concat(Enumerable.Range(0, 5000).Select(i => $"N{i + 1} X0.1 Y{(i % 2 == 0 ? "0.03" : "-0.03")}\nX0.1\n"))
            + "N9000 X1. Y1.\nG90 X600. Y0.\n";
        var path = Bench.Read(text);
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N2001..N4000"), 0.037).Result!;
        var now = NcInterpreter.Run(Bench.Rewritten(path, wish).Program, path.Dialect);
        Assert.Equal(path.Motions[^2].End, now.Motions[^2].End);
        Assert.Equal(1001, now.Motions[^2].End.X, 1e-12);
    }

    [Fact]
    public void Absolute_centers_are_kept_as_words_and_start_center_words_change()
    {
        const string Program = "G90 G17\nG90.1\nG0 X0. Y0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. I10. J5.\nN30 G1 X15. Y20.\n";
        var result = Bench.Normal(Program, 0.25, "N10..N30", NcDialects.LinuxCnc);
        Assert.Contains("N20 G3 X14.75 Y5. I10. J5.\n", result, StringComparison.Ordinal);
    }

    [Fact]
    public void Radius_near_half_a_turn_is_written_as_a_center_where_rounding_it_would_move_the_arc()
    {
        // The height of a half circle hangs on R by a square root: an R rounded to 0.001 can move its middle by 0.1 mm.
        var path = Bench.Read("G90 G17\nG0 X-6. Y-8.\nN10 G1 X0. Y0. F100\nN20 G2 X11.999 Y15.999 R10.\nN30 G1 X24. Y32.\n");
        var (was, centers) = (Bench.MotionOf(path, "N20").Arc, 0);
        for (var d = 0.0101; d < 0.02; d += 0.0003)
        {
            var rewrite = Bench.Rewritten(path, DisplacementWish.Normal(path, Bench.Blocks(path, "N20"), d).Result!);
            centers += Bench.Text(rewrite.Program).Contains('I', StringComparison.Ordinal) ? 1 : 0;
            var now = Bench.MotionOf(NcInterpreter.Run(rewrite.Program, path.Dialect), "N20").Arc;
            Assert.Equal(0, now.Middle.DistanceTo(was.Middle + (was.TangentAt(0.5).Left * d)), 0.0021);
        }

        Assert.InRange(centers, 1, 33);
    }

    [Fact]
    public void Inches_are_rounded_to_ten_thousandths()
    {
        // 0.0508 mm is 0.002 in.
        var result = Bench.Normal("G90 G17 G20\nG0 X0. Y0.\nN10 G1 X1. Y0. F10.\nN20 X1. Y1.\nN30 X0. Y1.\n", 0.0508, "N10..N20");
        Assert.Equal("G90 G17 G20\nG0 X0. Y0.002\nN10 G1 X0.998 Y0.002 F10.\nN20 X0.998 Y1.\nN30 X0. Y1.\n", result);
    }

    [Fact]
    public void Modal_coordinate_gains_its_word_behind_the_axis_before_it()
    {
        // N20 moves in Y only; its end slides along N30, which is oblique, so X no longer stays.
        var result = Bench.Normal("G90 G17\nG0 X0. Y0.\nN10 G1 X10. F100\nN20 Y10. M8\nN30 X0. Y20.\n", 0.1, "N20");
        Assert.Equal("G90 G17\nG0 X0. Y0.\nN10 G1 X9.9 F100\nN20 Y10.1 M8\nN30 X0. Y20.\n", result);
        var oblique = Bench.Normal("G90 G17\nG0 X0. Y0.\nN10 G1 X10. Y10. F100\nN20 Y20. (up) M8\nN30 X0.\n", 0.1, "N10");
        Assert.Contains("N10 G1 X10. Y10.141 F100\nN20 Y20. (up) M8\n", oblique, StringComparison.Ordinal);
        var gains = Bench.Normal("G90 G17\nG0 X0. Y0.\nN10 G1 X10. F100\nG0 Y10. M8\nX0.\n", 0.1, "N10");
        Assert.Contains("N10 G1 X10. F100\n", gains, StringComparison.Ordinal);
        var inserted = Bench.Normal("G90 G17\nG0 X5. Y5.\nN10 G1 Y15. F100\nG0 Y20. M8\nX0.\n", 0.1, "N10");
        Assert.Equal("G90 G17\nG0 X4.9 Y5.\nN10 G1 Y15. F100\nG0 X5. Y20. M8\nX0.\n", inserted);
    }

    [Fact]
    public void Lower_case_without_spaces_is_kept()
    {
        var result = Bench.Normal("g90g17\ng0x5.y5.\nn10g1y15.f100\ng0y20.m8\nx0.\n", 0.1, "N10");
        Assert.Equal("g90g17\ng0x4.9y5.\nn10g1y15.f100\ng0x5.y20.m8\nx0.\n", result);
    }

    [Fact]
    public void Spelling_is_kept()
    {
        var result = Bench.Normal(
            "G90 G17\r\nG0 X+00.000 Y+5.000\r\nN10 G1 X+10.000 Y+5.000 F100 ( wall )\r\nN20 X +10.000 Y -5.000\r\n", 0.5, "N10");
        Assert.Equal("G90 G17\r\nG0 X+00.000 Y+5.500\r\nN10 G1 X+10.000 Y+5.500 F100 ( wall )\r\nN20 X +10.000 Y -5.000\r\n", result);
    }

    [Fact]
    public void Compensated_path_moves_as_it_is_programmed()
    {
        var result = Bench.Normal(
            "G90 G17\nG0 X-10. Y-5.\nG41 D1 G1 X0. Y0. F100\nN10 X10. Y0.\nN20 X10. Y10.\nG40 G1 X20. Y20.\n", 0.1, "N10..N20");
        Assert.Equal("G90 G17\nG0 X-10. Y-5.\nG41 D1 G1 X0. Y0.1 F100\nN10 X9.9 Y0.1\nN20 X9.9 Y10.\nG40 G1 X20. Y20.\n", result);
    }
}
