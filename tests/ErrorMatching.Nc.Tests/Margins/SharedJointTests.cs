using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Where two named elements share a joint, or a named one and another that holds it.</summary>
public sealed class SharedJointTests
{
    // Tangent elements meet on their common normal. Along them, the joint has the sine of the angle, 0.099, times the displacement of
    // 0.1, and an increment: 0.0109.
    [Theory]
    [InlineData("X10.0109")]
    [InlineData("X9.9891")]
    [InlineData("X10.011", "3 N10: ", "4 N20: ")]
    [InlineData("X9.989", "3 N10: ", "4 N20: ")]
    [InlineData("X10.05", "3 N10: ", "4 N20: ")]
    public void Tangent_elements_meet_on_their_common_normal(string joint, params string[] found)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 X20. Y0.\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 {joint} Y0.1 F100\nN20 X20. Y0.1\nG0 Z5.\n";

        Assert.Equal(found, Ends(Verdict.OnElements(Before, after, ("N10", 0.1), ("N20", 0.1))));
    }

    // Both go to y = 0.1, N10 by 0.03 along itself and N20 by 0.07: the joint may stay where it was, or go by the mean of 0.05.
    [Theory]
    [InlineData("X10.")]
    [InlineData("X10.05")]
    [InlineData("X10.02", "3 N10: ", "4 N20: ")]
    [InlineData("X10.08", "3 N10: ", "4 N20: ")]
    public void Tangent_elements_that_go_along_meet_by_their_mean(string joint, params string[] found)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 X20. Y0.\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 {joint} Y0.1 F100\nN20 X20. Y0.1\nG0 Z5.\n";

        Assert.Equal(
            found,
            Ends(Verdict.OnVectors(Before, after, ("N10", new(0, 0.1), new(0.03, 0.1)), ("N20", new(0.07, 0.1), new(0, 0.1)))));
    }

    // N20 turns left by 2 degrees. At their joint both go by 0.1, at their other ends by 0.3: so they do not fix their joint. It went by
    // 0.05 along N10, which is 0.0017 away from N20.
    [Fact]
    public void Nearly_tangent_elements_that_go_alike_at_their_joint_do_not_fix_it()
    {
        var (sine, cosine) = Math.SinCos(2 * Math.PI / 180);
        var (x, y) = (10 + (10 * cosine), 10 * sine);
        var before = FormattableString.Invariant(
            $"G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 X{x:0.000000} Y{y:0.000000}\nG0 Z5.\n");
        var normal = new Vector2(-sine, cosine);
        var end = normal * 0.3;
        var after = FormattableString.Invariant(
            $"G90 G17\nG0 X0. Y0.3 Z0.\nN10 G1 X10.05 Y0.1 F100\nN20 X{x + end.X:0.000000} Y{y + end.Y:0.000000}\nG0 Z5.\n");

        Assert.Equal(
            ["3 N10: ", "4 N20: "],
            Ends(Verdict.OnVectors(before, after, ("N10", new(0, 0.3), new(0, 0.1)), ("N20", normal * 0.1, end))));
    }

    // The circle of 10.1 about the origin meets lines that leave it by 2.9 degrees from the radius at (10.1, 0.005) and (-0.005, 10.1).
    // Their directions are those of the arc at its other end.
    [Fact]
    public void An_arc_is_held_by_lines_across_it() =>
        Assert.Empty(Verdict.OnElements(
            "G90 G17\nG0 X0. Y-0.5 Z0.\nN10 G1 X10. Y0. F100\nN20 G3 X0. Y10. I-10. J0.\nN30 G1 X-0.5 Y20.\nG0 Z5.\n",
            "G90 G17\nG0 X0. Y-0.5 Z0.\nN10 G1 X10.1 Y0.005 F100\nN20 G3 X-0.005 Y10.1 I-10.1 J-0.005\nN30 G1 X-0.5 Y20.\nG0 Z5.\n",
            ("N20", -0.1)).Failures);

    // N20 begins with a radius of 5 and ends with 5.004. Its circle about (13, -4) crosses y = 0.1 at x = 13 - sqrt(25 - 4.1^2).
    [Fact]
    public void A_neighbor_may_miss_its_circle_by_as_much_as_its_radii_differ() =>
        Assert.Empty(Verdict.OnElements(
            "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 G2 X18.004 Y-4. I3. J-4.\nG0 Z5.\n",
            "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10.1381 Y0.1 F100\nN20 G2 X18.004 Y-4. I2.8619 J-4.1\nG0 Z5.\n",
            ("N10", 0.1)).Failures);

    // A rounding in two blocks behind two named lines, to y = 0.1 and x = 14.7: radius 4.8 about (9.9, 4.9).
    [Fact]
    public void The_joint_inside_a_rounding_behind_a_run_goes_along() =>
        Assert.Empty(Verdict.OnElements(
            "G90 G17\nG0 X0. Y0. Z0.\nN5 G1 X5. Y0. F100\nN10 X10. Y0.\nN20 G3 X13. Y1. I0. J5.\nN21 X15. Y5. I-3. J4.\nN30 G1 X15. Y15.\n",
            "G90 G17\nG0 X0. Y0.1 Z0.\nN5 G1 X5. Y0.1 F100\nN10 X9.9 Y0.1\nN20 G3 X12.78 Y1.06 I0. J4.8\nN21 X14.7 Y4.9 I-2.88 J3.84\n"
            + "N30 G1 X14.7 Y15.\n",
            ("N5", 0.1), ("N10", 0.1), ("N30", 0.3)).Failures);

    // Two cuts between named ones share a joint that nobody named.
    [Fact]
    public void A_joint_between_unnamed_cuts_stays()
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 X15. Y5.\nN30 X15. Y10.\nN40 X0. Y10.\nG0 Z5.\n";
        const string After = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10.1 Y0.1 F100\nN20 X15. Y5.\nN30 X15. Y9.9\nN40 X0. Y9.9\nG0 Z5.\n";
        const string Unnamed = "it moved although neither it nor a motion beside it was named.";

        Assert.Empty(Verdict.OnElements(Before, After, ("N10", 0.1), ("N40", 0.1)).Failures);
        Assert.Equal(
            ["4 N20: " + Unnamed, "5 N30: " + Unnamed],
            Verdict.Found(Verdict.OnElements(
                Before, After.Replace("Y5.", "Y5.001", StringComparison.Ordinal), ("N10", 0.1), ("N40", 0.1))));
    }

    // A free end may be an increment from where its wish puts it.
    [Theory]
    [InlineData("X10.001")]
    [InlineData("X9.999")]
    [InlineData("X10.0011", "3 N10: ")]
    public void A_free_end_may_be_an_increment_off(string end, params string[] found) =>
        Assert.Equal(
            found,
            Ends(Verdict.OnElements(
                "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nG0 Z5.\n",
                $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 {end} Y0.1 F100\nG0 Z5.\n",
                ("N10", 0.1))));

    // The quarter goes inward to 9.9; its neighbors are radii, so both ends slide along them. 1.6 increments are allowed.
    [Theory]
    [InlineData("9.9016")]
    [InlineData("9.8984")]
    [InlineData("9.9017", "it lies 0.0017 mm from where it was wanted.")]
    [InlineData("9.8983", "it lies 0.0017 mm from where it was wanted.")]
    public void An_arc_is_measured_with_the_rounding_of_its_center(string radius, string? found = null)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN5 G1 X10. Y0. F100\nN10 G3 X0. Y10. I-10. J0.\nN20 G1 X0. Y0.\nG0 Z5.\n";
        var after = Before.Replace("X10. Y0.", $"X{radius} Y0.", StringComparison.Ordinal)
            .Replace("X0. Y10. I-10.", $"X0. Y{radius} I-{radius}", StringComparison.Ordinal);
        var failures = Verdict.OnElements(Before, after, ("N10", 0.1)).Failures.Select(f => f.Message).Distinct();

        Assert.Equal(found is null ? [] : ["N10: " + found], failures);
    }

    // The ends that failed because nothing puts them where they are, each at its line and block.
    private static string[] Ends(NcProof proof) =>
    [
        .. Verdict.Found(proof).Where(f => f.EndsWith("puts it.", StringComparison.Ordinal))
            .Select(f => f[..(f.IndexOf(':', StringComparison.Ordinal) + 2)]),
    ];
}
