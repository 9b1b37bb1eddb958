using System.Globalization;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating.Tests;

/// <summary>Triangles and curves by closed forms.</summary>
public sealed class ShapeMatchTests
{
    private const string Flanks = "1 3 -4; 2 9 -12; 3 21 -12; 4 27 -4";
    private const string FlankLabels = """[["1", "2"], ["3", "4"]]""";

    [Fact]
    public void A_notch_that_is_higher_moves_its_apex_up()
    {
        // Flanks of slope 4/3 moved up by 0.12 meet 0.12 higher; they meet y = 0 where they did 0.09 further in.
        var match = Triangle(Programs.Notch, "N50..N60", Moved(0, 0.12, 0, 0.12));

        Assert.Equal(["N40 X0.09", "N50 X15. Y-19.88", "N60 X29.91 Y0."], match.Changed());
        Assert.All(match.Report().KeyPoints, p => Assert.Equal(0.072, p.NormalMm, 9));
    }

    [Fact]
    public void Each_flank_follows_its_own_points()
    {
        // The first flank 0.101 along its normal (4, 3)/5, the second stays:
        // their intersection slides 0.101 / sin of the angle between them (24/25) along the second, (3, 4)/5.
        var match = Triangle(Programs.Notch, "N50..N60", Moved(0.0808, 0.0606, 0, 0));

        Assert.Equal(["N40 X0.126", "N50 X15.063 Y-19.916"], match.Changed());
    }

    [Fact]
    public void A_notch_that_is_cut_the_other_way_round_is_the_same_notch()
    {
        var reversed = "%\nO1000\nN10 G21 G90 G17\nN20 G0 X50. Y20.\nN30 G1 G42 D1 Y0. F300\nN40 X30.\nN50 X15. Y-20.\nN60 X0. Y0.\nN70 "
            + "X-20.\nN80 G40 Y20.\nN90 M30\n%\n";
        var match = Triangle(reversed, "N50..N60", Moved(0.0808, 0.0606, 0, 0));

        Assert.Equal(["N50 X15.063 Y-19.916", "N60 X0.126 Y0."], match.Changed());
        Assert.All(match.Report().KeyPoints.Take(2), p => Assert.Equal(0.101, p.NormalMm, 9));
    }

    [Fact]
    public void A_fillet_in_a_notch_keeps_its_center_under_an_offset()
    {
        // Both flanks 0.1 inwards: radius 2.9 about the same center, which touches them 0.1 along their normals (0.8, 0.6) and (-0.8,
        // 0.6) from before.
        var match = Triangle(Programs.FilletedNotch, "N50..N60", Moved(0.08, 0.06, -0.08, 0.06));

        Assert.Equal(["N40 X0.125", "N50 X12.68 Y-16.74", "N55 G3 X17.32 Y-16.74 I2.32 J1.74", "N60 G1 X29.875 Y0."], match.Changed());
        Assert.Equal(0.1, match.Report().RadiusWearMm!.Value, 9);
    }

    [Fact]
    public void A_fillet_stays_tangent_when_one_flank_moves()
    {
        var match = Triangle(Programs.FilletedNotch, "N50..N60", Moved(0.08, 0.06, 0, 0));
        var arc = match.Motion("N55");

        Assert.True(arc.IsArc);
        Assert.InRange(Math.Abs(arc.TangentAt(0).Cross(new(0.6, -0.8))), 0, 0.001);
        Assert.InRange(Math.Abs(arc.TangentAt(1).Cross(new(0.6, 0.8))), 0, 0.001);
        Assert.Equal([0, 0, 0, 0], match.Report().KeyPoints.Select(p => Math.Round(p.PredictedMm, 2)));
    }

    [Fact]
    public void Ideal_actual_and_corrected_angles_of_a_notch_are_reported()
    {
        // The second flank's upper point is 0.1 out along the normal (-4, 3)/5.
        var match = Triangle(Programs.Notch, "N50..N60", "1 3 -4; 2 9 -12; 3 21 -12; 4 26.92 -3.94");
        var angle = Angle(match);

        // Ideal 2 atan(3/4); the flank of length 10 turned by atan(0.1 / 10) towards the other.
        var ideal = 2 * Math.Atan(0.75) * 180 / Math.PI;
        Assert.Equal(ideal, angle.Quantity.Theoretical, 9);
        Assert.Equal(ideal - (Math.Atan(0.01) * 180 / Math.PI), angle.Quantity.Actual, 9);
        Assert.Equal(angle.Quantity.Actual, angle.Corrected!.Value, 2);

        // Feedback: whatever the first counterpart was, the next one shall be what the part is.
        var feedback = Angle(match with { Counterpart = Moved(0.05, 0.02, -0.03, 0.04), Compensation = """{ "from": "counterpart" }""" });
        Assert.Equal(angle.Quantity.Actual, feedback.Corrected!.Value, 2);
        Assert.Equal(
            ideal,
            Angle(
                match with
                {
                    Part = Flanks,
                    Counterpart = "1 3 -4; 2 9 -12; 3 21 -12; 4 26.92 -3.94",
                    Compensation = """{ "from": "counterpart" }"""
                }).Corrected!.Value,
            2);

        static ReportQuantity Angle(MatchCase match) =>
            match.Report().Features[0].Quantities.Single(q => q.Quantity.Name == TriangleKind.IncludedAngle);
    }

    [Fact]
    public void An_arc_takes_the_radius_and_center_of_the_part()
    {
        // The part: radius 10.1 about (20.03, 0.02), met along the rays of the designed center.
        // It cuts y = 0 at 20.03 -+ sqrt(10.1^2 - 0.02^2).
        var (radius, x, y) = (10.1, 0.03, 0.02);
        var match = Curve(
            Programs.Hill,
            "N50",
            5,
            i => Ray(30 * (5 - i), u => (u.X * x) + (u.Y * y) + Math.Sqrt((radius * radius) - Math.Pow((x * u.Y) - (y * u.X), 2))));
        var arc = match.Motion("N50");

        var half = Math.Sqrt((radius * radius) - (y * y));
        Near((20 + x - half, 0), (arc.PlaneStart.X, arc.PlaneStart.Y));
        Near((20 + x + half, 0), (arc.PlaneEnd.X, arc.PlaneEnd.Y));
        Near((20 + x, y), (arc.Center.X, arc.Center.Y));
        Assert.Equal(MotionKind.ArcClockwise, arc.Kind);
        Assert.All(match.Report().KeyPoints, p => Assert.InRange(p.PredictedMm, -0.0015, 0.0015));
    }

    [Fact]
    public void An_arc_that_grows_keeps_its_center()
    {
        var match = Curve(Programs.Hill, "N50", 5, i => Ray(30 * (5 - i), _ => 10.05));

        Assert.Equal(["N40 X9.95 Y0.", "N50 G2 X30.05 Y0. I10.05 J0."], match.Changed());
        Assert.All(match.Report().KeyPoints, p => Assert.Equal(0.05, p.NormalMm, 6));
    }

    // 0, 0.075, 0.1, 0.075, 0 over 0 .. 40: their mean is 0.05, and 0.1 (1 - ((x - 20) / 20)^2) goes through all.
    [Theory]
    [InlineData(""" "degree": 0, "ridge": 0 """, new[] { 0.05, 0.05, 0.05, 0.05, 0.05 })]
    [InlineData(""" "degree": 1, "ridge": 0 """, new[] { 0.05, 0.05, 0.05, 0.05, 0.05 })]
    [InlineData(""" "degree": 2, "ridge": 0 """, new[] { 0, 0.075, 0.1, 0.075, 0 })]
    // 1 + 2^4 / 16 = 2: half of the curvature is left
    [InlineData(""" "degree": 2, "ridge": 0.0625 """, new[] { 0.025, 0.0625, 0.075, 0.0625, 0.025 })]
    public void A_polyline_follows_the_deviation_along_its_length(string fit, double[] up)
    {
        var program = "N20 G0 X0. Y40.\nN30 G1 G41 D1 Y20. F300\nN40 Y0.\nN50 X10.\nN60 X20.\nN70 X30.\nN80 X40.\nN90 Y20.\nN100 G40 "
            + "Y40.\nN110 M30\n";
        var match = Curve(program, "N50..N80", 5, i => (10 * i, new[] { 0, 0.075, 0.1, 0.075, 0 }[i]), i => (10 * i, 0), fit);

        Assert.Equal(
            up,
            new[] { "N40", "N50", "N60", "N70", "N80" }.Select(n => match.Motion(n).End.Y),
            (expected, found) => Math.Abs(expected - found) < 0.0006);
    }

    // Lagrange's polynomials through 0, 10 .. 40 have the signs + + - + - between the first two places, so these values add up there:
    // at 5 to 0.9 (35 + 140 + 70 + 28 + 5) / 128.
    [Fact]
    public void A_course_that_swings_beyond_the_limit_between_its_points_is_refused_by_its_block()
    {
        var program = "N20 G0 X0. Y40.\nN30 G1 G41 D1 Y20. F300\nN40 Y0.\nN50 X10.\nN60 X20.\nN70 X30.\nN80 X40.\nN90 Y20.\nN100 G40 "
            + "Y40.\nN110 M30\n";
        var match = Curve(
            program,
            "N50..N80",
            5,
            i => (10 * i, new[] { 0.9, 0.9, -0.9, 0.9, -0.9 }[i]),
            i => (10 * i, 0),
            """ "degree": 4, "ridge": 0 """) with
        {
            Compensation = """{ "limitMm": 1 }"""
        };

        var refusal = match.Refusal();
        Assert.Equal(("implausible-course", "N50", 4), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
        Assert.Equal("N50", refusal.Values[0]);
        Assert.Equal(1.955, double.Parse(refusal.Values[2], CultureInfo.InvariantCulture), 3);
        Assert.Equal("1", refusal.Values[3]);
    }

    [Fact]
    public void Along_the_vector_the_vertices_of_a_polyline_move_by_it()
    {
        var program = "N20 G0 X0. Y40.\nN30 G1 G41 D1 Y20. F300\nN40 Y0.\nN50 X10.\nN60 X20.\nN70 X30.\nN80 X40.\nN90 Y20.\nN100 G40 "
            + "Y40.\nN110 M30\n";
        var match = Curve(program, "N50..N80", 5, i => ((10 * i) + 0.2, 0.1), i => (10 * i, 0), """ "degree": 0, "ridge": 0 """) with
        {
            Compensation = """{ "along": "vector" }"""
        };

        // The upright neighbors keep their x.
        Assert.Equal(["N40 Y0.1", "N50 X10.2", "N60 X20.2", "N70 X30.2"], match.Changed());
    }

    [Fact]
    public void A_point_without_length_in_a_polyline_does_not_cut_the_feature_in_two()
    {
        var program = "N20 G0 X0. Y40.\nN30 G1 G41 D1 Y20. F300\nN40 Y0.\nN50 X10.\nN60 X20.\nN65 X20.\nN70 X30.\nN80 X40.\nN90 "
            + "Y20.\nN100 G40 Y40.\nN110 M30\n";
        var match = Curve(program, "N50..N80", 5, i => (10 * i, 0.1), i => (10 * i, 0), """ "degree": 0, "ridge": 0 """);

        Assert.Equal(["N40 Y0.1"], match.Changed());
        Assert.Single(match.Match().Maps[0].Passes);
        Assert.All(match.Report().KeyPoints, p => Assert.Equal(0, p.PredictedMm, 6));
    }

    // The tool's center goes 13 about (20, -10), the boundary 10: a quarter of it is 10 pi/2 long, and deviations count along it.
    [Fact]
    public void Lengths_are_those_of_the_boundary_not_of_the_path()
    {
        var program = "N10 G21 G90 G17\nN20 G0 X0. Y20.\nN40 G1 Y3. F300\nN50 X20.\nN60 G2 X33. Y-10. I0. J-13.\nN70 G1 Y-30.\nN80 M30\n";
        double[] degrees = [75, 45, 15];
        (double X, double Y)[] places = [
            (4, 0),
            (10, 0),
            (16, 0),
            .. degrees.Select(a => (20 + (10 * Math.Cos(a * Math.PI / 180)), -10 + (10 * Math.Sin(a * Math.PI / 180))))];
        double[] lengths = [4, 10, 16, .. degrees.Select(a => 20 + (10 * (90 - a) * Math.PI / 180))];
        var match = Curve(program, "N50..N60", 6, i => places[i], i => places[i]);
        var pass = match.Match().Maps[0].Passes[0];

        Assert.Equal(lengths, pass.Feet.Select(pass.Along), (expected, found) => Math.Abs(expected - found) < 1e-6);
    }

    private static MatchCase Triangle(string program, string blocks, string part) =>
        new(program) { Theoretical = Flanks, Part = part, Features = [MatchCase.Feature("triangle", "T1", blocks, FlankLabels)] };

    private static MatchCase Curve(
        string program,
        string blocks,
        int count,
        Func<int, (double X, double Y)> part,
        Func<int, (double X, double Y)>? theoretical = null,
        string fit = """ "degree": "auto" """) =>
        new(program)
        {
            Theoretical = Points(count, theoretical ?? (i => Ray(30 * (5 - i), _ => 10))),
            Part = Points(count, part),
            Features = [MatchCase.Feature("curve", "C1", blocks, $"""["0..{count - 1}"]""", $""" "toleranceMm": [0, 0], {fit} """)],
        };

    private static string Points(int count, Func<int, (double X, double Y)> at) =>
        string.Join(
            "; ", Enumerable.Range(0, count).Select(i => FormattableString.Invariant($"{i} {at(i).X:0.0000000} {at(i).Y:0.0000000}")));

    // The flanks' points, each flank moved by its own vector.
    private static string Moved(double x1, double y1, double x2, double y2) =>
        FormattableString.Invariant($"1 {3 + x1} {-4 + y1}; 2 {9 + x1} {-12 + y1}; 3 {21 + x2} {-12 + y2}; 4 {27 + x2} {-4 + y2}");

    private static (double X, double Y) Ray(double degrees, Func<(double X, double Y), double> length)
    {
        var u = (X: Math.Cos(degrees * Math.PI / 180), Y: Math.Sin(degrees * Math.PI / 180));
        return (20 + (u.X * length(u)), u.Y * length(u));
    }

    private static void Near((double X, double Y) expected, (double X, double Y) found)
    {
        Assert.Equal(expected.X, found.X, 0.0011);
        Assert.Equal(expected.Y, found.Y, 0.0011);
    }
}
