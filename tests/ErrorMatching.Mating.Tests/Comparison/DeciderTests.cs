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

    [Theory]
    [InlineData("0.0301", Decision.NotSignificant)]
    [InlineData("0.0299", Decision.Compensated)]
    public void A_deviation_must_exceed_twice_its_standard_uncertainty(string uncertainty, Decision expected)
    {
        var line = Decide([0.06, 0.01], uncertainty: uncertainty).Features[0];

        Assert.Equal(expected, line.Decision);
        Assert.Equal(double.Parse(uncertainty, System.Globalization.CultureInfo.InvariantCulture), line.StandardUncertaintyMm);
        Assert.Equal(expected == Decision.Compensated ? 0.06 : 0, line.Points[0].CorrectionNormalMm, 12);
        Assert.Equal(0.01, line.Points[0].ExcessMm, 12);
    }

    [Fact]
    public void Feedback_compares_two_measured_points_and_is_less_certain()
    {
        var job = SampleJob.With(
            ("\"dialect\"", "\"measured\": \"c.csv\", \"dialect\""),
            ("\"from\": \"part\"", "\"from\": \"counterpart\""),
            ("0.002", "0.0225"));

        // 2 * sqrt(2) * 0.0225 = 0.0636 mm.
        Assert.Equal(Decision.NotSignificant, Decider.Decide(job, Points(job, Line([0.06, 0]))).Features[0].Decision);
        Assert.Equal(Decision.Compensated, Decider.Decide(job, Points(job, Line([0.064, 0]))).Features[0].Decision);
        Assert.Equal(Math.Sqrt(2) * 0.0225, Decider.Decide(job, Points(job, Line([0.064, 0]))).Features[0].StandardUncertaintyMm, 12);
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
        Assert.Contains("Point 2 of L1 is 1.001 mm off, more than the 1 mm", refusal.Message, StringComparison.Ordinal);
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
                var (c, d) = (p.CorrectionNormalMm, p.Point.NormalMm);
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
