using ErrorMatching.Geometry;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Mating.Tests;

public sealed class DeciderTests
{
    private static readonly Vector2 Normal = new(-0.6, 0.8);

    [Fact]
    public void Inside_the_tolerance_nothing_is_compensated()
    {
        var line = Decide([0.05, -0.05]).Features[0];

        Assert.Equal(
            (Decision.WithinTolerance, true), (line.Decision, line.Points.All(p => p.Correction == Vector2.Zero && p.ExcessMm == 0)));
    }

    [Fact]
    public void Outside_the_tolerance_the_whole_deviation_is_compensated_at_every_point_along_the_normal()
    {
        var decision = Decide([0.06, -0.02], tangential: 0.3);
        var line = decision.Features[0];

        Assert.Equal((Decision.Compensated, true, true), (line.Decision, decision.IsUsable, decision.Compensates));
        Assert.Equal(0.06, line.LargestMm, 12);
        Assert.Equal([0.06, -0.02], line.Points.Select(p => Math.Round(p.CorrectionNormalMm, 12)));
        Assert.Equal(-0.036, line.Points[0].Correction.X, 12);
        Assert.Equal(0.048, line.Points[0].Correction.Y, 12);
        Assert.Equal([0.01, 0], line.Points.Select(p => Math.Round(p.ExcessMm, 12)));
    }

    [Fact]
    public void A_part_that_stands_out_toward_the_tool_pushes_the_boundary_toward_the_tool()
    {
        // The counterpart's material is at x < 0, its tool at x > 0, the part's material too. A part that ends at x = 0.1 instead of 0 has
        // a hollow there, which the counterpart must fill.
        var job = SampleJob.With();
        var point = new BoundaryPoint("1", new(0, 0), new(0.1, 0), new(1, 0));
        var features = Points(job, [point, point with { Label = "2" }]);

        Assert.Equal(0.1, Decider.Decide(job, features).Features[0].Points[0].Correction.X, 12);
    }

    [Fact]
    public void Excess_compensates_at_each_point_what_is_beyond_its_limit() =>
        Assert.Equal([0.02, 0, -0.01], Corrections([0.07, 0.05, -0.06], "\"amount\": \"excess\""));

    [Fact]
    public void A_gain_takes_its_share_of_the_deviation() => Assert.Equal([0.05, -0.01, 0], Corrections([0.1, -0.02, 0], "\"gain\": 0.5"));

    [Fact]
    public void A_vector_is_compensated_literally_and_its_excess_in_proportion()
    {
        var whole = Decide([0.1, 0.01], "\"along\": \"vector\", \"gain\": 0.5", 0.2).Features[0].Points[0].Correction;
        var excess = Decide([0.1, 0.01], "\"along\": \"vector\", \"amount\": \"excess\"", 0.2).Features[0].Points;

        var displacement = (Normal * 0.1) + (Normal.Left * 0.2);
        Assert.Equal(0, (whole - (displacement * 0.5)).Length, 12);
        Assert.Equal(0, (excess[0].Correction - (displacement * 0.5)).Length, 12);
        Assert.Equal(0, excess[1].Correction.Length, 12);
    }

    [Fact]
    public void A_vector_without_a_normal_component_has_no_excess() =>
        Assert.Equal(Vector2.Zero, Decide([0, 0.1], "\"along\": \"vector\", \"amount\": \"excess\"", 0.2).Features[0].Points[0].Correction);

    // 16 points without tolerance: 2.951 u. 0.06 / 2.951 = 0.02033.
    [Theory]
    [InlineData("0.0204", Decision.NotSignificant)]
    [InlineData("0.0203", Decision.Compensated)]
    public void A_deviation_must_exceed_what_a_perfect_part_can_show(string uncertainty, Decision expected)
    {
        var job = Untoleranced(("0.002", uncertainty));
        var line = Decider.Decide(job, Points(job, Line([0.06, 0.01]))).Features[0];

        Assert.Equal(expected, line.Decision);
        var u = double.Parse(uncertainty, System.Globalization.CultureInfo.InvariantCulture);
        Assert.Equal(u, line.StandardUncertaintyMm);
        Assert.Equal(2.95096 * u, line.SignificantMm, 6);
        Assert.Equal(expected == Decision.Compensated ? 0.06 : 0, line.Points[0].CorrectionNormalMm, 12);
        Assert.Equal(0.06, line.Points[0].ExcessMm, 12);
    }

    [Fact]
    public void Feedback_compares_two_measured_points_and_is_less_certain()
    {
        var job = Untoleranced(
            ("\"dialect\"", "\"measured\": \"c.csv\", \"dialect\""),
            ("\"from\": \"part\"", "\"from\": \"counterpart\""),
            ("0.002", "0.0225"));

        // 2.951 * sqrt(2) * 0.0225 = 0.0939 mm.
        Assert.Equal(Decision.NotSignificant, Decider.Decide(job, Points(job, Line([0.0938, 0]))).Features[0].Decision);
        Assert.Equal(Decision.Compensated, Decider.Decide(job, Points(job, Line([0.0940, 0]))).Features[0].Decision);
        Assert.Equal(Math.Sqrt(2) * 0.0225, Decider.Decide(job, Points(job, Line([0.064, 0]))).Features[0].StandardUncertaintyMm, 12);
    }

    [Fact]
    public void The_point_outside_must_be_the_significant_one()
    {
        // -0.05 is significant and allowed, 0.015 is neither: the gauge may show it on a part that is good there.
        var job = SampleJob.With(("[-0.05, 0.05]", "[-0.06, 0.01]"), ("0.002", "0.01"));

        Assert.Equal(Decision.NotSignificant, Decider.Decide(job, Points(job, Line([-0.05, 0.015]))).Features[0].Decision);
        Assert.Equal(Decision.Compensated, Decider.Decide(job, Points(job, Line([-0.05, 0.04]))).Features[0].Decision);
    }

    // g = 0.01 * 1.6449: 0.0336 is accepted, 0.0335 is the limit.
    [Theory]
    [InlineData("\"simple\"", 0.04, Decision.WithinTolerance, 0)]
    [InlineData("\"guard-band\"", 0.0335, Decision.WithinTolerance, 0)]
    [InlineData("\"guard-band\"", 0.0336, Decision.Compensated, 0.0336)]
    [InlineData("\"guard-band\", \"riskPercent\": 15.865525", 0.0399, Decision.WithinTolerance, 0)]
    [InlineData("\"guard-band\", \"riskPercent\": 15.865525", 0.0401, Decision.Compensated, 0.0401)]
    public void Guard_bands_move_the_limits_inward(string rule, double off, Decision expected, double correction)
    {
        var job = SampleJob.With(
            ("0.002", "0.01"), ("\"compensation\"", $$"""
                "decision": { "rule": {{rule}} }, "compensation"
                """));
        var line = Decider.Decide(job, Points(job, Line([off, 0]))).Features[0];

        Assert.Equal((expected, correction), (line.Decision, Math.Round(line.Points[0].CorrectionNormalMm, 9)));
    }

    [Fact]
    public void The_excess_is_what_lies_beyond_the_acceptance_limit()
    {
        var job = SampleJob.With(
            ("0.002", "0.01"), ("\"from\": \"part\" }", "\"amount\": \"excess\" }, \"decision\": { \"rule\": \"guard-band\" }"));
        var point = Decider.Decide(job, Points(job, Line([0.06, 0]))).Features[0].Points[0];

        Assert.Equal(0.01 + 0.016449, point.ExcessMm, 6);
        Assert.Equal(point.ExcessMm, point.CorrectionNormalMm, 12);
    }

    [Fact]
    public void Probabilities_of_conformance_multiply_from_points_to_the_pair()
    {
        // On a limit 1/2, one u outside 0.1587; 14 points in the middle of limits 5 and 4.. 6 u away.
        var job = SampleJob.With(("0.002", "0.01"));
        var decision = Decider.Decide(job, Points(job, Line([0.05, 0.06])));
        var line = decision.Features[0];

        Assert.Equal([0.5, 0.1586553], line.Points.Select(p => Math.Round(p.ProbabilityBefore!.Value, 7)));
        Assert.Equal(0.5 * 0.1586553, line.ProbabilityBefore!.Value, 7);
        Assert.Equal(line.ProbabilityBefore.Value * (1 - (4 * 3.167e-5) - (10 * 5.733e-7)), decision.ProbabilityBefore!.Value, 8);
        Assert.Null(Decider.Decide(Untoleranced(), Points(Untoleranced(), Line([0.06, 0.01]))).ProbabilityBefore);
    }

    [Fact]
    public void A_deviation_beyond_the_plausibility_limit_refuses_the_job_by_feature_and_point()
    {
        Assert.True(Decide([1.0, 0]).IsUsable);
        var decision = Decide([0, 1.001]);

        var refusal = Assert.Single(decision.Refusals);
        Assert.Equal(
            ("implausible-deviation", "L1", "2", false),
            (refusal.Code, refusal.Place.Feature, refusal.Place.Point, decision.IsUsable));
        Assert.Equal(["2", "L1", "1.001", "1"], refusal.Values);
        Assert.Equal(Decision.Compensated, decision.Features[0].Decision);
    }

    [Fact]
    public void A_point_that_is_off_along_the_boundary_is_not_plausible_either() => Assert.False(Decide([0, 0], tangential: 1.1).IsUsable);

    [Fact]
    public void Points_must_be_those_of_the_job_in_their_order()
    {
        var job = SampleJob.With();
        var points = Points(job, Line([0, 0]));

        Assert.Throws<ArgumentException>(() => Decider.Decide(job, [.. points.Skip(1)]));
        Assert.Throws<ArgumentException>(() => Decider.Decide(job, [[points[0][1], points[0][0]], .. points.Skip(1)]));
    }

    [Fact]
    public void What_is_compensated_never_exceeds_the_deviation_and_never_turns_its_sign()
    {
        var size = Gen.Choose(-900, 900).Select(n => n / 1000.0).ToArbitrary();
        Check.QuickThrowOnFailure(Prop.ForAll(size, size, ArbMap.Default.ArbFor<bool>(), (a, b, whole) =>
        {
            var points = Decide([a, b], $"\"amount\": \"{(whole ? "whole" : "excess")}\"").Features[0].Points;
            return points.All(p =>
            {
                var (c, d) = (p.CorrectionNormalMm, p.Point.DecidedMm);
                return Math.Abs(c) <= Math.Abs(d) + 1e-12 && c * d >= -1e-12 && (p.Correction - (Normal * c)).Length < 1e-12;
            });
        }));
    }

    [Fact]
    public void One_uniform_offset_has_a_wear_value()
    {
        var job = SampleJob.With();
        var uniform = Decider.Decide(job, [.. job.Features.Select(f => f.Points.Select(l => Point(l, 0.08)).ToArray())]);
        var uneven = Decider.Decide(job, [.. job.Features.Select(f => f.Points.Select(l => Point(l, l == "7" ? 0.0812 : 0.08)).ToArray())]);
        var partly = Decider.Decide(job, Points(job, Line([0.08, 0.08])));

        Assert.Equal(0.08, UniformOffset.RadiusWearMm(uniform)!.Value, 12);
        Assert.Null(UniformOffset.RadiusWearMm(uneven));
        Assert.Null(UniformOffset.RadiusWearMm(partly));
    }

    private static MatingJob Untoleranced(params (string Found, string Instead)[] more) =>
        SampleJob.With([("[-0.05, 0.05]", "[0, 0]"), ("[-0.04, 0.06]", "[0, 0]"), .. more]);

    private static double[] Corrections(double[] normals, string compensation)
    {
        var job = SampleJob.With(("[\"1\", \"2\"]", "[\"1\", \"2\", \"2.5\"]"), ("\"from\": \"part\"", compensation));
        return [.. Decider.Decide(job, Points(job, Line(normals))).Features[0].Points.Select(p => Math.Round(p.CorrectionNormalMm, 12))];
    }

    private static MatingDecision Decide(
        double[] normals, string compensation = "\"from\": \"part\"", double tangential = 0, string uncertainty = "0.002")
    {
        var job = SampleJob.With(("\"from\": \"part\"", compensation), ("0.002", uncertainty));
        return Decider.Decide(job, Points(job, Line(normals, tangential)));
    }

    private static BoundaryPoint[] Line(double[] normals, double tangential = 0)
    {
        string[] labels = ["1", "2", "2.5"];
        return [.. normals.Select((n, i) => Point(labels[i], n, tangential))];
    }

    private static BoundaryPoint Point(string label, double normal, double tangential = 0)
    {
        var present = new Point2(3, 4);
        return new(label, present, present + (Normal * normal) + (Normal.Left * tangential), Normal);
    }

    private static BoundaryPoint[][] Points(MatingJob job, BoundaryPoint[] line) =>
        [line, .. job.Features.Skip(1).Select(f => f.Points.Select(l => Point(l, 0)).ToArray())];
}
