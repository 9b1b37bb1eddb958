using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

public sealed class VerifierTests
{
    private const string Complex = "complex-mating";

    [Fact]
    public void The_papers_improvements_come_out_of_the_sample()
    {
        var job = Samples.Job(
            Complex,
            new AngleComparison("L1-L2", new("L1", null), new("L2L3", 1)),
            new DeviationComparison("C1 without the corner", true, ["6", "7", "8", "9", "10", "11", "12", "13", "14"]));

        var result = Verifier.Verify(job, Samples.Verified(Complex, job));

        // Section 4.3: straight line 81 % by the angle between L1 and L2, triangle 87 % by the angle between L2 and L3,
        // curve 79 % from 0.137 to 0.029 mm.
        AssertFeature(result, "L1-L2", VerifiedQuantity.Angle, 118.948, 119.542, 119.061, 81, 3);
        AssertFeature(result, "L2L3", VerifiedQuantity.Angle, 63.948, 64.878, 63.83, 87, 3);
        AssertFeature(result, "C1 without the corner", VerifiedQuantity.DeviationX, 0, 0.137, 0.029, 79, 9);

        // Each says whose deviation it is; a length or an angle is no point's.
        string[] curve = ["5", "6", "7", "8", "9", "10", "11", "12", "13", "14"];
        Assert.All(result.Features.Where(f => f.Name == "C1"), f => Assert.Equal(curve, f.Points));
        Assert.Equal(curve.Skip(1), result.Features.Single(f => f.Name == "C1 without the corner").Points);
        Assert.All(result.Features, f => Assert.Equal(f.Quantity.IsDeviation, f.Points.Count > 0));

        // The point beside the corner is what the paper leaves out.
        AssertFeature(result, "C1", VerifiedQuantity.DeviationX, 0, 0.137, 0.056, 59, 9);
    }

    [Fact]
    public void The_corner_of_the_paper_is_off_by_0_371_and_0_391()
    {
        var job = Samples.Job(Complex);

        var corner = Verifier.Verify(job, Samples.Verified(Complex, job)).Points.Single(p => p.Label == "4");

        Assert.Equal(0.371, corner.BeforeError.Vector.X, 9);
        Assert.Equal(0.391, corner.AfterError.Vector.X, 9);
        Assert.Equal(-0.371, corner.BeforeError.NormalMm, 9);
    }

    [Fact]
    public void The_root_mean_square_is_taken_along_the_normals()
    {
        VerifiedPoint[] points =
        [
            new("1", new(0, 0), new(5, 0.3), new(0, 0.1), new(0, 1)),
            new("2", new(1, 0), new(1, -0.4), new(7, 0), new(0, 1)),
        ];

        var result = new VerificationResult(points, []);

        Assert.Equal(Math.Sqrt((0.09 + 0.16) / 2), result.RmsBeforeMm, 12);
        Assert.Equal(Math.Sqrt(0.01 / 2), result.RmsAfterMm, 12);
    }

    [Fact]
    public void A_mating_error_has_the_parts_limits_the_other_way_round() =>
        Assert.Equal(new ToleranceBand(-0.05, 0.02), new VerifiedBoundary("C1", new(-0.02, 0.05), [], []).ErrorBand);

    [Fact]
    public void The_line_of_the_paper_is_as_long_as_its_points_are_apart()
    {
        var job = Samples.Job(Complex);

        var length = Verifier.Verify(job, Samples.Verified(Complex, job)).Features.Single(f => f.Quantity == VerifiedQuantity.Length);

        // Tables 5 to 7: the distances of points 1 and 2. The paper prints 17.592 for the last, which its points do not have.
        Assert.Equal(
            ("L1", 17.649, 17.308, 17.562),
            (length.Name, Math.Round(length.Wanted, 3), Math.Round(length.Before, 3), Math.Round(length.After, 3)));
    }

    [Fact]
    public void The_curve_of_the_paper_is_within_0_048_after_compensation()
    {
        var job = Samples.Job("curve-mating");

        var deviation = Verifier.Verify(job, Samples.Verified("curve-mating", job)).Features.Single(
            f => f.Quantity == VerifiedQuantity.DeviationX);

        // The direct difference of tables 3 and 2, and that of 4 and 2 with point 7 read as 1.339.
        Assert.Equal(0.320, deviation.Before, 9);
        Assert.Equal(0.048, deviation.After, 9);
    }

    [Fact]
    public void Every_kind_of_feature_yields_its_quantities()
    {
        var job = Samples.Job(Complex);

        var features = Verifier.Verify(job, Samples.Verified(Complex, job)).Features;

        Assert.Equal(
            [
                ("L1", VerifiedQuantity.Deviation), ("L1", VerifiedQuantity.DeviationX), ("L1", VerifiedQuantity.Length),
                ("L2L3", VerifiedQuantity.Deviation), ("L2L3", VerifiedQuantity.DeviationX), ("L2L3", VerifiedQuantity.Angle),
                ("C1", VerifiedQuantity.Deviation), ("C1", VerifiedQuantity.DeviationX),
                ("L1-L2", VerifiedQuantity.Angle), ("C1 in x", VerifiedQuantity.DeviationX),
            ],
            features.Select(f => (f.Name, f.Quantity)));
    }

    [Fact]
    public void Deviations_are_taken_along_the_normals()
    {
        var (job, points) = SmallCase(before: new(0.3, 0.4), after: new(0, 0.1));

        var result = Verifier.Verify(job, points);

        // Along (0.6, 0.8): 0.18 + 0.32 and 0.08.
        Assert.Equal((0.5, 0.08), (Math.Round(result.MaxBeforeMm, 12), Math.Round(result.MaxAfterMm, 12)));
        var deviation = result.Features.First(f => f.Quantity == VerifiedQuantity.Deviation);
        Assert.Equal(84, deviation.ImprovementPercent!.Value, 9);
        Assert.Equal(0.3, result.Features.First(f => f.Quantity == VerifiedQuantity.DeviationX).Before, 12);
    }

    [Fact]
    public void An_error_that_grew_is_a_negative_improvement_and_no_error_has_none()
    {
        var (job, points) = SmallCase(before: new(0.1, 0), after: new(-0.3, 0));
        Assert.Equal(
            -200, Verifier.Verify(job, points).Features.First(f => f.Quantity == VerifiedQuantity.DeviationX).ImprovementPercent!.Value, 9);

        (job, points) = SmallCase(before: new(0, 0.1), after: new(0, 0.1));
        Assert.Null(Verifier.Verify(job, points).Features.First(f => f.Quantity == VerifiedQuantity.DeviationX).ImprovementPercent);
    }

    // A length depends on one coordinate of each end. Both counterparts are measured: twice the variance of one.
    [Theory]
    [InlineData(true, 2)]
    [InlineData(false, 1.4142136)]
    public void The_uncertainty_of_a_change_follows_from_the_gauges(bool isBeforeMeasured, double times)
    {
        var (job, points) = SmallCase(before: new(0.3, 0.4), after: new(0, 0.1));
        var u = job.Gauge.Uncertainty.CombinedMm;

        var result = Verifier.Verify(job, points, isBeforeMeasured);

        Assert.True(u > 0);
        Assert.Equal(times, result.Features.Single(f => f.Quantity == VerifiedQuantity.Length).ChangeUncertainty!.Value / u, 4);
        Assert.Equal(
            times / Math.Sqrt(2), result.Features.First(f => f.Quantity == VerifiedQuantity.Deviation).ChangeUncertainty!.Value / u, 6);
    }

    // Expanded uncertainty of the change: 0.02.
    [Theory]
    [InlineData(0.05, 0.0301, "within u")]
    [InlineData(0.05, 0.0299, "40")]
    [InlineData(0.05, 0.0699, "within u")]
    [InlineData(0.05, 0.0701, "-40")]
    [InlineData(0.001, 0.015, "within u")]
    [InlineData(0.001, -0.0211, "worse")]
    [InlineData(0.001, 0.0209, "within u")]
    [InlineData(0, 0.5, "-")]
    public void A_change_below_the_gauges_uncertainty_has_no_percentage(double before, double after, string words)
    {
        var feature = new VerifiedFeature("L1", VerifiedQuantity.Length, 17, 17 + before, 17 + after) { ChangeUncertainty = 0.01 };

        Assert.Equal(words, ImprovementWords.Of(feature, p => p.ToString("0", CultureInfo.InvariantCulture), "-"));
        Assert.Equal(
            words switch { "within u" => "Within u: ", "worse" => "Better, worse: ", _ => null },
            ImprovementWords.Legend([feature]).SingleOrDefault()?.Split(": ")[0] is { } start ? start + ": " : null);
    }

    [Fact]
    public void A_change_of_unknown_uncertainty_is_a_percentage() => Assert.Equal(
        "-1400",
        ImprovementWords.Of(
            new("L1", VerifiedQuantity.Length, 17, 17.001, 17.015), p => p.ToString("0", CultureInfo.InvariantCulture), "-"));

    [Fact]
    public void Elements_that_go_straight_on_enclose_180_degrees()
    {
        var job = SampleJob.With() with
        {
            Verify = [
                new AngleComparison("straight", new("L1", null), new("L2L3", 1)),
                new AngleComparison("corner", new("L2L3", 1), new("L2L3", 2))]
        };
        var places = new Dictionary<string, Point2>(StringComparer.Ordinal)
        {
            ["1"] = new(0, 0),
            ["2"] = new(1, 0),
            ["2a"] = new(2, 0),
            ["3a"] = new(3, 0),
            ["3b"] = new(3, 1),
            ["4"] = new(0, 4)
        };

        var result = Verifier.Verify(job, Points(job, l => places.GetValueOrDefault(l, Point2.Origin)));

        Assert.Equal(180, result.Features.Single(f => f.Name == "straight").Wanted, 9);

        // Out along +x, back up and to the left at 135 degrees: 45 degrees inside.
        Assert.Equal(45, result.Features.Single(f => f.Name == "corner").Wanted, 9);
        Assert.Equal(45, result.Features.Single(f => f.Name == "L2L3" && f.Quantity == VerifiedQuantity.Angle).Wanted, 9);
    }

    [Fact]
    public void Points_must_be_those_of_the_job()
    {
        var job = SampleJob.With();

        Assert.Throws<ArgumentException>(() => Verifier.Verify(job, [.. Points(job, _ => Point2.Origin).Take(2)]));
    }

    private static (MatingJob Job, VerifiedPoint[][] Points) SmallCase(Vector2 before, Vector2 after)
    {
        var job = SampleJob.With();
        job = job with { Features = [job.Features[0]] };
        return (job, [[Point("1", new(0, 0)), Point("2", new(0, 5))]]);

        VerifiedPoint Point(string label, Point2 at) => new(label, at, at + before, at + after, new(0.6, 0.8));
    }

    private static VerifiedPoint[][] Points(MatingJob job, Func<string, Point2> place) =>
        [.. job.Features.Select(f => f.Points.Select(l => new VerifiedPoint(l, place(l), place(l), place(l), new(1, 0))).ToArray())];

    private static void AssertFeature(
        VerificationResult result,
        string name,
        VerifiedQuantity quantity,
        double wanted,
        double before,
        double after,
        double improvement,
        int digits)
    {
        var feature = Assert.Single(result.Features, f => f.Name == name && f.Quantity == quantity);
        Assert.Equal(wanted, feature.Wanted, digits);
        Assert.Equal(before, feature.Before, digits);
        Assert.Equal(after, feature.After, digits);
        Assert.Equal(improvement, feature.ImprovementPercent!.Value, 0);
    }
}
