namespace ErrorMatching.Nc.Tests;

/// <summary>
/// The arc N20 of radius 5 rounds the corner of N10, which goes 0.1 mm to the left, and N30, which goes 0.3 mm: to y = 0.1 and x = 14.7.
/// Its radius changes by the mean of the two, to 4.8; so it lies about (9.9, 4.9) and touches the lines at (9.9, 0.1) and (14.7, 4.9).
/// </summary>
public sealed class FilletProofTests
{
    private const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. I0. J5.\nN30 G1 X15. Y15.\nG0 Z5.\n";
    private const string After = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X9.9 Y0.1 F100\nN20 G3 X14.7 Y4.9 I0. J4.8\nN30 G1 X14.7 Y15.\nG0 Z5.\n";

    // The same corner from its end to its start, with the material on the other side.
    private const string BeforeClockwise =
        "G90 G17\nG0 X15. Y15. Z0.\nN30 G1 X15. Y5. F100\nN20 G2 X10. Y0. I-5. J0.\nN10 G1 X0. Y0.\nG0 Z5.\n";
    private const string AfterClockwise =
        "G90 G17\nG0 X14.7 Y15. Z0.\nN30 G1 X14.7 Y4.9 F100\nN20 G2 X9.9 Y0.1 I-4.8 J0.\nN10 G1 X0. Y0.1\nG0 Z5.\n";

    // A corner of 270 degrees: the lines cross at (0, 0) behind the arc's start and before its end, the arc of radius 5 lies about (5, -5).
    private const string BeforeLoop = "G90 G17\nG0 X-10. Y0. Z0.\nN10 G1 X5. Y0. F100\nN20 G2 X0. Y-5. I0. J-5.\nN30 G1 X0. Y10.\nG0 Z5.\n";
    private const string AfterLoop =
        "G90 G17\nG0 X-10. Y0.1 Z0.\nN10 G1 X5. Y0.1 F100\nN20 G2 X-0.3 Y-5.2 I0. J-5.3\nN30 G1 X-0.3 Y10.\nG0 Z5.\n";

    [Fact]
    public void A_fillet_is_where_both_lines_and_its_radius_put_it()
    {
        Assert.Empty(Verdict.OnElements(Before, After, ("N10", 0.1), ("N30", 0.3)).Failures);
        Assert.Empty(Verdict.OnElements(BeforeClockwise, AfterClockwise, ("N10", -0.1), ("N30", -0.3)).Failures);
    }

    // To the left of both lines lies the outside of a clockwise arc: its radius grows by 0.2 to 5.2.
    // It touches y = 0.1 and x = -0.3 about (4.9, -5.1).
    [Fact]
    public void A_fillet_of_more_than_half_a_turn_is_measured_alike()
    {
        var good = AfterLoop.Replace("X5. Y0.1", "X4.9 Y0.1", StringComparison.Ordinal)
            .Replace("X-0.3 Y-5.2 I0. J-5.3", "X-0.3 Y-5.1 I0. J-5.2", StringComparison.Ordinal);

        Assert.Empty(Verdict.OnElements(BeforeLoop, good, ("N10", 0.1), ("N30", 0.3)).Failures);
        Assert.False(Verdict.OnElements(BeforeLoop, AfterLoop, ("N10", 0.1), ("N30", 0.3)).Holds);
    }

    // Where it touches counts to the rounding of a word: the circle is the right one in all of these.
    [Theory]
    [InlineData("X9.9 Y0.1 F100", "X9.9007 Y0.1 F100", "I0. J4.8", "I-0.0007 J4.8", true)]
    [InlineData("X9.9 Y0.1 F100", "X9.9008 Y0.1 F100", "I0. J4.8", "I-0.0008 J4.8", false)]
    [InlineData("X9.9 Y0.1 F100", "X9.8993 Y0.1 F100", "I0. J4.8", "I0.0007 J4.8", true)]
    [InlineData("X9.9 Y0.1 F100", "X9.8992 Y0.1 F100", "I0. J4.8", "I0.0008 J4.8", false)]
    [InlineData("X14.7 Y4.9", "X14.7 Y4.9007", "I0.", "I0.", true)]
    [InlineData("X14.7 Y4.9", "X14.7 Y4.9008", "I0.", "I0.", false)]
    [InlineData("X14.7 Y4.9", "X14.7 Y4.8993", "I0.", "I0.", true)]
    [InlineData("X14.7 Y4.9", "X14.7 Y4.8992", "I0.", "I0.", false)]
    public void A_tangent_point_is_held_to_the_rounding(string was, string now, string wasCenter, string nowCenter, bool holds)
    {
        var result = After.Replace(was, now, StringComparison.Ordinal).Replace(wasCenter, nowCenter, StringComparison.Ordinal);

        Assert.Equal(holds, Verdict.OnElements(Before, result, ("N10", 0.1), ("N30", 0.3)).Holds);
    }

    // Without an increment, a millionth is left, and from zero the words say it exactly: the fillet touches at the origin, at its start
    // or at its end.
    [Theory]
    [InlineData("X-10. Y0.", "X0. Y0.", "X5. Y5.", "X5. Y15.", "X0.000001 Y0.", "X5. Y5.", false)]
    [InlineData("X-10. Y0.", "X0. Y0.", "X5. Y5.", "X5. Y15.", "X0.0000011 Y0.", "X5. Y5.", true)]
    [InlineData("X-15. Y-5.", "X-5. Y-5.", "X0. Y0.", "X0. Y10.", "X-5. Y-5.", "X0. Y0.000001", false)]
    [InlineData("X-15. Y-5.", "X-5. Y-5.", "X0. Y0.", "X0. Y10.", "X-5. Y-5.", "X0. Y0.0000011", true)]
    public void A_tangent_point_is_held_to_the_limit_itself(
        string from, string start, string end, string to, string startNow, string endNow, bool isFound)
    {
        string Text(string s, string e) => $"G90 G17\nG0 {from} Z0.\nN10 G1 {s} F100\nN20 G3 {e} R5.\nN30 G1 {to}\nG0 Z5.\n";
        var path = Bench.Read(Text(start, end));
        var wishes = new[] { "N10", "N20", "N30" }.Select(
            b => ElementWish.AlongNormals(path, path.MotionOf(Bench.Blocks(path, b)[0]), 0, 0, 0, b == "N20"));
        var proof = Prover.Check(path, NcProgram.FromText(Text(startNow, endNow)), DisplacementWish.OfElements([.. wishes]), 0);

        Assert.Equal(isFound, Messages(proof).Contains("N20: the fillet does not end where it touches the lines beside it."));
    }

    // A circle that touches both lines, but whose radius is an increment or two off, or that took the change of one line only.
    [Theory]
    [InlineData(4.799)]
    [InlineData(4.801)]
    [InlineData(4.7)]
    [InlineData(4.9)]
    public void A_fillet_of_another_radius_that_touches_both_lines_is_not_proved(double radius)
    {
        var result = FormattableString.Invariant(
            $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X{14.7 - radius:0.0##} Y0.1 F100\nN20 G3 X14.7 Y{0.1 + radius:0.0##} I0. J{radius:0.0##}\n")
            + "N30 G1 X14.7 Y15.\nG0 Z5.\n";

        Assert.False(Verdict.OnElements(Before, result, ("N10", 0.1), ("N30", 0.3)).Holds);
    }

    // An arc that leaves its line by 2.8 degrees rounds a corner, at 3.0 degrees it does not:
    // then it follows its ends, about another center.
    [Theory]
    [InlineData(2.8, 0, true)]
    [InlineData(3.0, 0, false)]
    [InlineData(0, 2.8, true)]
    [InlineData(0, 3.0, false)]
    public void An_arc_is_a_fillet_as_long_as_it_leaves_its_lines_tangentially(double atStart, double atEnd, bool isFillet)
    {
        var (sine, cosine) = Math.SinCos(atStart * Math.PI / 180);
        var (sineAtEnd, cosineAtEnd) = Math.SinCos(atEnd * Math.PI / 180);
        var before = FormattableString.Invariant($"G90 G17\nG0 X{-10 * cosine:0.000000} Y{-10 * sine:0.000000} Z0.\nN10 G1 X0. Y0. F100\n")
            + FormattableString.Invariant(
                $"N20 G3 X5. Y5. I0. J5.\nN30 G1 X{5 - (10 * sineAtEnd):0.000000} Y{5 + (10 * cosineAtEnd):0.000000}\nG0 Z5.\n");
        var path = Bench.Read(before);
        var elements = new[]
        {
            "N10",
            "N30"
        }.Select(b => ElementWish.AlongNormals(path, path.MotionOf(Bench.Blocks(path, b)[0]), 0.1, 0.1, 0.1));
        var wish = DisplacementWish.OfElements([.. elements]);
        var proof = Prover.Check(path, Bench.Usable(Rewriter.Apply(path, wish)).Program, wish, 0.001);

        Assert.Empty(proof.Failures);
        Assert.Equal(isFillet ? NeighborRole.Fillet : NeighborRole.Follows, proof.Neighbors.Single(n => n.Block == "N20").Role);
    }

    // Both ends are right, but the center lies aside by d to the right and d down: the middle lies 0.414 d off.
    // 1.6 increments are allowed, 0.0016 mm.
    [Theory]
    [InlineData("I0.0038 J4.7962", true)]
    [InlineData("I0.004 J4.796", false)]
    public void The_middle_of_a_fillet_is_held_to_the_rounding_of_its_center(string center, bool holds)
    {
        var result = After.Replace("I0. J4.8", center, StringComparison.Ordinal);

        Assert.Equal(holds, Verdict.OnElements(Before, result, ("N10", 0.1), ("N30", 0.3)).Holds);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(6)]
    public void A_fillet_no_larger_than_the_displacement_of_its_lines_is_not_proved(double left)
    {
        var failures = Verdict.OnElements(Before, After, ("N10", left), ("N30", left)).Failures;

        Assert.Contains(failures, f => f.Message.Contains("no arc of the radius", StringComparison.Ordinal));
    }

    // The arc touches two lines, but only one of them is displaced: it is no fillet then, and the proof holds all the same.
    [Theory]
    [InlineData("N10")]
    [InlineData("N30")]
    public void An_arc_beside_one_displaced_line_is_no_fillet(string named)
    {
        var path = Bench.Read(Before);
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, named), 0.1));
        var proof = Prover.Check(path, Bench.Usable(Rewriter.Apply(path, wish)).Program, wish, 0.001);

        Assert.Empty(proof.Failures);
        Assert.DoesNotContain(proof.Neighbors, n => n.Role == NeighborRole.Fillet);
    }

    // N21 and N22 are no fillet of their own behind N20, so the joint between them stays. The result is right where N20 is not named.
    [Fact]
    public void Arcs_behind_a_named_arc_of_their_circle_are_no_fillet()
    {
        const string Left = "it moved although neither it nor a motion beside it was named.";
        var before = Before.Replace(
            "N20 G3 X15. Y5. I0. J5.\n",
            "N20 G3 X13. Y1. I0. J5.\nN21 X14. Y2. I-3. J4.\nN22 X15. Y5. I-4. J3.\n",
            StringComparison.Ordinal);
        const string Result = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100\nN20 G3 X12.94 Y1.08 I0. J4.9\n"
            + "N21 X13.92 Y2.06 I-2.94 J3.92\nN22 X14.9 Y5. I-3.92 J2.94\nN30 G1 X14.9 Y15.\nG0 Z5.\n";

        Assert.Empty(Messages(Verdict.OnElements(before, Result, ("N10", 0.1), ("N30", 0.1))));
        Assert.Equal(
            ["N21: " + Left, "N22: " + Left],
            Messages(Verdict.OnElements(before, Result, ("N10", 0.1), ("N20", 0.1), ("N30", 0.1))));
    }

    // An arc in two blocks that nobody named: the rewriter makes what was written by hand here.
    [Fact]
    public void A_fillet_in_two_blocks_that_nobody_named_goes_along()
    {
        var path = Bench.Read(Before.Replace(
            "N20 G3 X15. Y5. I0. J5.\n", "N20 G3 X13. Y1. I0. J5.\nN21 X15. Y5. I-3. J4.\n", StringComparison.Ordinal));
        var elements = new[] { ("N10", 0.1), ("N30", 0.3) }
            .Select(w => ElementWish.AlongNormals(path, path.MotionOf(Bench.Blocks(path, w.Item1)[0]), w.Item2, w.Item2, w.Item2));
        var rewrite = Bench.Rewritten(path, DisplacementWish.OfElements([.. elements]));

        Assert.Contains(
            "N20 G3 X12.78 Y1.06 I0. J4.8\nN21 X14.7 Y4.9 I-2.88 J3.84\n", Bench.Text(rewrite.Program), StringComparison.Ordinal);
    }

    // In two arcs that meet at 3 to 4 below the center: at (13, 1) before and at (9.9 + 0.6 * 4.8, 4.9 - 0.8 * 4.8) = (12.78, 1.06) behind.
    // From there the second arc's center lies at (-2.88, 3.84). Five increments of the joint are free along the circle.
    [Theory]
    [InlineData("X12.78 Y1.06", "I-2.88 J3.84", true)]
    [InlineData("X12.7836 Y1.0627", "I-2.8836 J3.8373", true)]
    [InlineData("X12.784 Y1.063", "I-2.884 J3.837", true)]
    [InlineData("X12.7843 Y1.0632", "I-2.8843 J3.8368", false)]
    public void A_joint_inside_a_fillet_keeps_its_direction_from_the_center(string joint, string center, bool holds)
    {
        const string Two = "N20 G3 X13. Y1. I0. J5.\nN21 X15. Y5. I-3. J4.\n";
        var before = Before.Replace("N20 G3 X15. Y5. I0. J5.\n", Two, StringComparison.Ordinal);
        var result = After.Replace(
            "N20 G3 X14.7 Y4.9 I0. J4.8\n", $"N20 G3 {joint} I0. J4.8\nN21 X14.7 Y4.9 {center}\n", StringComparison.Ordinal);

        Assert.Equal(holds, Verdict.OnElements(before, result, ("N10", 0.1), ("N30", 0.3)).Holds);
    }

    // N30 stays, so the rounding must touch x = 15 at (15, 5.05). One that follows its start alone, about (10.0844, 5.0149), touches
    // neither line, and one that keeps its center meets y = 0.1 at an angle of 11 degrees.
    [Theory]
    [InlineData("X10.05 Y0.1", "X15. Y5.05 I0. J4.95", true)]
    [InlineData("X10. Y0.1", "X15. Y5. I0.0844 J4.9149", false)]
    [InlineData("X10.995 Y0.1", "X15. Y5. I-0.995 J4.9", false)]
    public void A_fillet_beside_a_named_line_that_stays_touches_both(string start, string arc, bool holds)
    {
        var result = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 {start} F100\nN20 G3 {arc}\nN30 G1 X15. Y15.\nG0 Z5.\n";

        Assert.Equal(holds, Verdict.OnElements(Before, result, ("N10", 0.1), ("N30", 0)).Holds);
    }

    // The same from the other side: N10 stays, and N30 goes by 0.1.
    [Theory]
    [InlineData("X9.95 Y0.", "X14.9 Y4.95 I0. J4.95", true)]
    [InlineData("X10. Y0.", "X14.9 Y5. I-0.0149 J4.9156", false)]
    [InlineData("X10. Y0.", "X14.9 Y4.005 I0. J5.", false)]
    public void A_fillet_behind_a_named_line_that_stays_touches_both(string start, string arc, bool holds)
    {
        var result = $"G90 G17\nG0 X0. Y0. Z0.\nN10 G1 {start} F100\nN20 G3 {arc}\nN30 G1 X14.9 Y15.\nG0 Z5.\n";

        Assert.Equal(holds, Verdict.OnElements(Before, result, ("N10", 0), ("N30", 0.1)).Holds);
    }

    [Theory]
    [InlineData("I0. J4.8")]
    [InlineData("I0.004 J4.796", "N20: it lies 0.0017 mm from where it was wanted.")]
    public void A_fillet_that_was_named_as_one_is_measured_alike(string center, params string[] found)
    {
        var path = Bench.Read(Before);
        var wishes = new[] { ("N10", 0.1, 0.1, false), ("N20", 0.1, 0.3, true), ("N30", 0.3, 0.3, false) }.Select(w =>
            ElementWish.AlongNormals(path, path.MotionOf(Bench.Blocks(path, w.Item1)[0]), w.Item2, 0.2, w.Item3, w.Item4));
        var result = NcProgram.FromText(After.Replace("I0. J4.8", center, StringComparison.Ordinal));

        Assert.Equal(found, Messages(Prover.Check(path, result, DisplacementWish.OfElements([.. wishes]), 0.001)));
    }

    // At 4.803 from the center, both arcs are 0.003 off where they meet, and their radii differ.
    // The second has the radius of its start, so it is off halfway as well.
    [Fact]
    public void A_joint_inside_a_fillet_is_on_its_circle()
    {
        const string Radii = "the radii at its start and end differ by more than a control accepts.";
        const string Off = "it lies 0.0030 mm from where it was wanted.";
        var before = Before.Replace(
            "N20 G3 X15. Y5. I0. J5.\n", "N20 G3 X13. Y1. I0. J5.\nN21 X15. Y5. I-3. J4.\n", StringComparison.Ordinal);
        var result = After.Replace(
            "N20 G3 X14.7 Y4.9 I0. J4.8\n",
            "N20 G3 X12.7818 Y1.0576 I0. J4.8\nN21 X14.7 Y4.9 I-2.8818 J3.8424\n",
            StringComparison.Ordinal);

        Assert.Equal(
            ["N20: " + Radii, "N20: " + Off, "N21: " + Radii, "N21: " + Off, "N21: " + Off],
            Messages(Verdict.OnElements(before, result, ("N10", 0.1), ("N30", 0.3))));
    }

    // By as much as its radii differ, a fillet may be off: 5 and 5.003. So may a second arc by as much as it is larger than the first:
    // 5 and 5.005. N30 lies by as much further to the right, and its tangent point goes along.
    [Theory]
    [InlineData("N20 G3 X15.003 Y5. I0. J5.\n", "X15.003", "X9.903", "N20 G3 X14.703 Y4.9 I0. J4.8\n", "X14.703")]
    [InlineData(
        "N20 G3 X13. Y1. I0. J5.\nN21 X15.002 Y5.004 I-3.003 J4.004\n",
        "X15.002",
        "X9.902",
        "N20 G3 X12.782 Y1.06 I0. J4.8\nN21 X14.702 Y4.9 I-2.88 J3.84\n",
        "X14.702")]
    public void A_fillet_may_be_off_by_the_difference_of_its_radii(string arc, string line, string start, string arcNow, string lineNow)
    {
        var before = $"G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\n{arc}N30 G1 {line} Y15.\nG0 Z5.\n";
        var result = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 {start} Y0.1 F100\n{arcNow}N30 G1 {lineNow} Y15.\nG0 Z5.\n";

        Assert.Empty(Messages(Verdict.OnElements(before, result, ("N10", 0.1), ("N30", 0.3))));
    }

    // Where the coordinates of its center are zero, as those of a motion without a center are.
    [Fact]
    public void A_fillet_may_lie_about_the_origin()
    {
        const string AtOrigin = "G90 G17\nG0 X-10. Y-5. Z0.\nN10 G1 X0. Y-5. F100\nN20 G3 X5. Y0. I0. J5.\nN30 G1 X5. Y10.\nG0 Z5.\n";
        const string Result =
            "G90 G17\nG0 X-10. Y-4.9 Z0.\nN10 G1 X-0.1 Y-4.9 F100\nN20 G3 X4.7 Y-0.1 I0. J4.8\nN30 G1 X4.7 Y10.\nG0 Z5.\n";
        var proof = Verdict.OnElements(AtOrigin, Result, ("N10", 0.1), ("N30", 0.3));

        Assert.Empty(proof.Failures);
        Assert.Equal(NeighborRole.Fillet, proof.Neighbors.Single(n => n.Block == "N20").Role);
    }

    // The second arc's center is I to the right of the first's, which is the origin; its radius is 4.994, and that of the first is 5.
    // At a hundredth they are two circles, which round nothing: they do not put the end of N10, which stays on its line.
    [Theory]
    [InlineData("I0.0099", false)]
    [InlineData("I0.01", true)]
    public void Arcs_of_two_circles_are_no_fillet(string center, bool isFound)
    {
        const string Head = "G90 G17 G21 G90.1\nG0 X-10. Y-5. Z0.\nN10 G1 X0. Y-5. F100\n";
        var rest = $"N20 G3 X3. Y-4. I0. J0.\nN21 X5.004 Y0. {center} J0.\nN30 G1 X5.004 Y10.\nG0 Z5.\n";
        var path = Bench.Read(Head + rest, NcDialects.LinuxCnc);
        var wishes = new[] { "N10", "N30" }.Select(b => ElementWish.AlongNormals(
            path, path.MotionOf(Bench.Blocks(path, b)[0]), 0, 0, 0));
        var result = (Head + rest).Replace("X0. Y-5.", "X0.004 Y-5.", StringComparison.Ordinal);
        var proof = Prover.Check(
            path, NcProgram.FromText(result, path.Dialect.Syntax), DisplacementWish.OfElements([.. wishes]), 0.001);

        Assert.Equal(isFound, Messages(proof).Contains(
            "N10: an end moved by (0.004, 0.000), where neither the wish nor a neighbor puts it."));
    }

    // The lines beside N20 go round the origin as those beside an arc about it do. But N20 is a line, which puts the end of N10: at
    // y = 5.1, its x is -6 * 0.1 / 5.
    [Theory]
    [InlineData("X-0.12 Y5.1")]
    [InlineData("X0.03 Y5.1", "N10: an end moved by (0.030, 0.100), where neither the wish nor a neighbor puts it.")]
    public void A_line_about_the_origin_is_no_fillet(string end, params string[] found)
    {
        static string Text(string y, string e) =>
            $"G90 G17\nG0 X-10. Y{y} Z0.\nN10 G1 {e} F100\nN20 X6. Y0.\nN30 X6. Y-10.\nG0 Z5.\n";

        Assert.Equal(found, Messages(Verdict.OnElements(Text("5.", "X0. Y5."), Text("5.1", end), ("N10", 0.1), ("N30", 0))));
    }

    // An arc with nothing behind it rounds no corner: it does not put the end of the line before it.
    [Fact]
    public void An_arc_at_the_end_of_a_program_is_no_fillet() =>
        Assert.Equal(
            ["N10: an end moved by (0.050, 0.100), where neither the wish nor a neighbor puts it."],
            Messages(Verdict.OnElements(
                "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. R5.\n",
                "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10.05 Y0.1 F100\nN20 G3 X15. Y5. R5.\n",
                ("N10", 0.1))).Where(m => m.StartsWith("N10", StringComparison.Ordinal)));

    // The place that G92 sets is known, so a line may be the first motion of all. N10 stays: a radius of 5 - 0.15 touches it at 9.85.
    [Fact]
    public void A_fillet_may_be_the_second_motion()
    {
        const string Head = "G90 G17 G92 X0. Y0. Z0.\n";
        var proof = Verdict.OnElements(
            Head + "N10 G1 X10. F100\nN20 G3 X15. Y5. I0. J5.\nN30 G1 X15. Y15.\nG0 Z5.\n",
            Head + "N10 G1 X9.85 F100\nN20 G3 X14.7 Y4.85 I0. J4.85\nN30 G1 X14.7 Y15.\nG0 Z5.\n",
            ("N10", 0),
            ("N30", 0.3));

        Assert.Empty(proof.Failures);
        Assert.Equal(NeighborRole.Fillet, proof.Neighbors.Single(n => n.Block == "N20").Role);
    }

    // In the plane of N10, its travel has the numbers of the direction in which N20 begins. But N20 leaves it at a right angle, so it
    // rounds nothing, and does not put the end of N30.
    [Fact]
    public void A_line_in_another_plane_has_no_fillet()
    {
        const string Text = "G90 G18\nG0 X0. Y0. Z0.\nN10 G1 X10. F100\nG17\nN20 G3 X5. Y5. R5.\nN30 G1 X-5. Y5.\nG0 Z5.\n";
        var result = Text.Replace("X5. Y5.", "X5.05 Y4.9", StringComparison.Ordinal)
            .Replace("X-5. Y5.", "X-5. Y4.9", StringComparison.Ordinal);

        Assert.Contains(
            "N30: an end moved by (0.050, -0.100), where neither the wish nor a neighbor puts it.",
            Messages(Verdict.OnElements(Text, result, ("N10", 0), ("N30", 0.1))));
    }

    private static string[] Messages(NcProof proof) => [.. proof.Failures.Select(f => f.Message)];
}
