using ErrorMatching.Geometry;
using MathNet.Numerics.Distributions;

namespace ErrorMatching.Mating.Tests;

/// <summary>How often the decision compensates a perfect part, and how often it sees a point that is off.</summary>
public sealed class SignificanceTests(ITestOutputHelper output)
{
    private const int Parts = 2000;
    private const double U = 0.0054;

    // Three standard deviations of a share of 5 % in this many parts.
    private static readonly double Scatter = 3 * Math.Sqrt(0.05 * 0.95 / Parts);

    private static readonly Vector2 Up = new(0, 1);

    // The normal quantile of (1 + 0.9505^(1/N)) / 2.
    [Theory]
    [InlineData(1, 1.96426)]
    [InlineData(2, 2.24041)]
    [InlineData(7, 2.68624)]
    [InlineData(16, 2.95096)]
    [InlineData(60, 3.33737)]
    public void Without_tolerance_the_factor_is_the_quantile_for_all_points(int points, double expected)
    {
        Assert.Equal(expected, Significance.Factor([(ToleranceBand.Zero, points)], U), 4);
        Assert.Equal(expected, Significance.Factor([(new(-U, U), points)], U), 4);
        Assert.Equal(0, Significance.Factor([(new(-1.001 * expected * U, 1.001 * expected * U), points)], U));
    }

    [Fact]
    public void Points_that_their_limits_keep_silent_cost_nothing()
    {
        // Only the two points with narrow limits can alarm.
        Assert.Equal(2.24041, Significance.Factor([(new(-0.05, 0.05), 14), (new(-0.01, 0.01), 2)], U), 4);

        // One limit far away: half of the alarms, so the quantile of the one-sided test.
        Assert.Equal(1.649721, Significance.Factor([(new(-0.05, 0.001), 1)], U), 4);
        Assert.Equal(1.649721, Significance.Factor([(new(-0.001, 0.05), 1)], U), 4);
    }

    [Fact]
    public void A_perfect_part_outside_shifted_limits_alarms_like_one_without_limits() =>
        Assert.Equal(1.96426, Significance.Factor([(new(0.06, 0.07), 1)], U), 4);

    [Fact]
    public void A_gauge_without_error_makes_everything_significant() => Assert.Equal(0, Significance.Factor([(ToleranceBand.Zero, 16)], 0));

    [Theory]
    [InlineData(0)]
    [InlineData(0.5)]
    [InlineData(1.85)] // +-0.01 mm for 5.4 um
    [InlineData(2.5)]
    [InlineData(2.9)]
    [InlineData(3.1)]
    [InlineData(9.3)]
    public void At_most_5_percent_of_perfect_parts_are_compensated(double limitsInU)
    {
        var limits = FormattableString.Invariant($"[{-limitsInU * U}, {limitsInU * U}]");
        var job = Job(("[-0.05, 0.05]", limits), ("[-0.04, 0.06]", limits));

        Assert.InRange(Compensated(job, common: 0, off: 0), 0, 0.05 + Scatter);
    }

    [Fact]
    public void At_most_5_percent_with_a_different_tolerance_for_each_feature()
    {
        var job = Job(("[-0.05, 0.05]", "[-0.05, 0.002]"), ("[-0.04, 0.06]", "[-0.01, 0.016]"));
        Assert.InRange(Compensated(job, common: 0, off: 0), 0.02, 0.05 + Scatter);
    }

    // Temperature and clamping shift all points of a part alike: 5.39 of 5.4 um in the paper's budget. The job states it.
    [Theory]
    [InlineData(0.5)]
    [InlineData(0.9)]
    [InlineData(1)]
    public void Errors_that_all_points_share_make_fewer_alarms(double common) =>
        Assert.InRange(Compensated(Shared(common), common, 0), 0, 0.05 + Scatter);

    [Fact]
    public void A_shared_error_that_the_job_does_not_state_is_taken_for_one_of_the_part() =>
        Assert.InRange(Compensated(Job(("[-0.05, 0.05]", "[0, 0]"), ("[-0.04, 0.06]", "[0, 0]")), 0.9, 0), 0.2, 1);

    // Sixteen points that are off by 2 u: 8 standard deviations together, where each alone is below its threshold.
    [Theory]
    [InlineData(2)]
    [InlineData(-2)]
    public void What_all_points_have_in_common_is_seen_in_95_percent(double offInU)
    {
        var limits = FormattableString.Invariant($"[{-U}, {U}]");
        var job = Job(("[-0.05, 0.05]", limits), ("[-0.04, 0.06]", limits));
        Assert.InRange(Compensated(job, 0, 0, _ => offInU), 0.95, 1);
        Assert.InRange(Compensated(Shared(0.9), 0.9, 0, _ => offInU), 0, 0.7);
    }

    // The seven points of a curve of 60 mm, alternately off by what each may show, are only noise to the sums.
    [Fact]
    public void What_they_do_not_have_in_common_is_not()
    {
        var points = Enumerable.Range(0, 8).Select(i => new SignificantPoint(new(10 * i, 0), Up, i % 2 == 0 ? 2 : -2)).ToArray();
        Assert.Equal([false], Significance.Together([points], [false], 1, 0));
        Assert.Equal([true], Significance.Together([[.. points.Select(p => p with { Mm = 2 })]], [false], 1, 0));
    }

    // A turn has no mean, and a shift none around a circle.
    [Theory]
    [InlineData("turn")]
    [InlineData("shift")]
    [InlineData("growth")]
    public void Each_common_cause_has_its_sum(string cause)
    {
        var points = Enumerable.Range(0, 12).Select(i =>
        {
            var normal = cause == "turn" ? Up : new Vector2(Elementary.Cos(Math.PI * i / 6), Elementary.Sin(Math.PI * i / 6));
            var place = cause == "turn" ? new Point2(10 * i, 0) : Point2.Origin + (normal * 20);
            return new SignificantPoint(
                place, normal, cause switch { "turn" => 0.5 * (i - 5.5), "shift" => 2.5 * normal.Y, _ => 1.5 });
        }).ToArray();
        Assert.Equal([true], Significance.Together([points], [false], 1, 0));
        Assert.Equal([false], Significance.Together([[.. points.Select(p => p with { Mm = 0.6 * p.Mm })]], [false], 1, 0));
    }

    // Two features of four points, each off by 1.8 u: 3.6 standard deviations alone, 5.1 together.
    [Fact]
    public void Features_are_off_together_where_none_is_alone()
    {
        SignificantPoint[] Feature(double y, double mm) =>
            [.. Enumerable.Range(0, 4).Select(i => new SignificantPoint(new(10 * i, y), Up, mm))];
        Assert.Equal([true, true], Significance.Together([Feature(0, 1.8), Feature(30, 1.8)], [false, false], 1, 0));
        Assert.Equal([false, false], Significance.Together([Feature(0, 1.8), Feature(30, 0)], [false, false], 1, 0));

        // One that is off by itself says nothing of the other.
        Assert.Equal([true, false], Significance.Together([Feature(0, 50), Feature(30, 1.8)], [true, false], 1, 0));
    }

    [Fact]
    public void A_single_point_of_7_that_is_3_5_u_off_is_seen_with_80_percent()
    {
        // Seen, or another point alarms: 1 - (1 - (B(3.5 - k) + B(-3.5 - k))) (1 - 2 B(-k))^6.
        var k = Significance.Factor([(ToleranceBand.Zero, 7)], U);
        var power = 1 - ((1 - Normal.CDF(0, 1, 3.5 - k) - Normal.CDF(0, 1, -3.5 - k)) * Math.Pow(1 - (2 * Normal.CDF(0, 1, -k)), 6));
        Assert.InRange(power, 0.80, 0.81);

        // Only the curve, with 7 points.
        var job = Job(
            ("""{ "name": "L1", "kind": "line", "points": ["1", "2"], "blocks": ["N100"], "toleranceMm": [-0.05, 0.05] },""", ""),
            ("""{ "name": "L2L3", "kind": "triangle", "points": [["2a", "3a"], ["3b", "4"]], """, ""),
            ("\"blocks\": [\"N110..N130\"], \"toleranceMm\": [-0.04, 0.06] },", ""),
            ("5..14", "5..11"),
            ("[-0.05, 0.05]", "[0, 0]"));
        Assert.InRange(Compensated(job, 0, 3.5), power - 0.025, power + 0.025);
    }

    [Fact]
    public void No_test_of_this_size_sees_a_single_point_of_16_noticeably_better()
    {
        // Neyman and Pearson: against one point somewhere, off by +-3.5 u, the mean of cosh(3.5 z) is the best statistic.
        const int Trials = 20_000;
        var random = new Random(26);
        var (silent, best, seen, alarmed) = (new double[Trials], new double[Trials], 0, 0);
        var k = Significance.Factor([(ToleranceBand.Zero, 16)], 1);
        for (var i = 0; i < Trials; i++)
        {
            double[] z = [.. Enumerable.Range(0, 16).Select(_ => Normal.Sample(random, 0, 1))];
            silent[i] = z.Sum(v => Math.Cosh(3.5 * v));
            alarmed += z.Any(v => Math.Abs(v) > k) ? 1 : 0;
            z[i % 16] += 3.5;
            best[i] = z.Sum(v => Math.Cosh(3.5 * v));
            seen += z.Any(v => Math.Abs(v) > k) ? 1 : 0;
        }

        Array.Sort(silent);
        var threshold = silent[(int)(0.95 * Trials)];
        Assert.InRange((double)alarmed / Trials, 0.045, 0.055);
        Assert.InRange((double)best.Count(b => b > threshold) / Trials - ((double)seen / Trials), -0.01, 0.01);
        Assert.InRange((double)seen / Trials, 0.71, 0.74);
    }

    // The share of parts of which the decision compensates something. Every part has normal errors of u, of which a share of the variance
    // is common to its points, and one point that is off by so many u.
    private double Compensated(MatingJob job, double common, double off, Func<string, double>? all = null)
    {
        var random = new Random(2026);
        var compensated = 0;
        for (var part = 0; part < Parts; part++)
        {
            var (together, at) = (Normal.Sample(random, 0, 1), part % job.KeyPoints.Count);
            IReadOnlyList<BoundaryPoint>[] points = [
                .. job.Features.Select(f => (IReadOnlyList<BoundaryPoint>)[
                    .. f.Points.Select(l => Point(l, (job.KeyPoints[at] == l ? off : 0) + (all?.Invoke(l) ?? 0), together))])];
            compensated += Decider.Decide(job, points).Compensates ? 1 : 0;
        }

        var share = (double)compensated / Parts;
        output.WriteLine($"{share:P2} of the parts are compensated");
        return share;

        BoundaryPoint Point(string label, double offInU, double together)
        {
            var z = offInU + (Math.Sqrt(common) * together) + (Math.Sqrt(1 - common) * Normal.Sample(random, 0, 1));
            return new(label, default, Point2.Origin + (Up * (U * z)), Up);
        }
    }

    private static MatingJob Shared(double common) => SampleJob.With(
        ("\"uncertaintyMm\": 0.002", FormattableString.Invariant(
            $$"""
            "uncertaintyMm": [{ "name": "probing", "valueMm": {{U * Math.Sqrt(1 - common)}} },
              { "name": "temperature", "valueMm": {{U * Math.Sqrt(common)}}, "shared": true }], "acceptCoarse": true
            """)),
        ("[-0.05, 0.05]", "[0, 0]"),
        ("[-0.04, 0.06]", "[0, 0]"));

    private static MatingJob Job(params (string Found, string Instead)[] replacements) =>
        SampleJob.With([("\"uncertaintyMm\": 0.002", "\"uncertaintyMm\": 0.0054, \"acceptCoarse\": true"), .. replacements]);
}
