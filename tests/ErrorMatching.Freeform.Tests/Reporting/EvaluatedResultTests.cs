using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform.Tests;

public sealed class EvaluatedResultTests
{
    private static readonly ReportJob Job = new("Saddle", "WO-1", "job.json", new('0', 64));
    private static readonly JobStock Stock = new(0.4, 0.2);
    private static readonly ErrorSample Sample = new(7, 1, 2, 0.5, 0.5, new(1, 2, 3), new(0, 0.6, 0.8), 0.01);

    [Theory]
    [InlineData(CuttingStage.SemiFinishing, 0.2)]
    [InlineData(CuttingStage.Finishing, 0)]
    public void A_point_is_wanted_where_the_stock_of_its_stage_is_and_was_measured_its_error_over_it(CuttingStage stage, double stock)
    {
        var point = Assert.Single(EvaluatedResult.Of(Job, Stock, null, Piece(stage)).Points);
        Assert.Equal(("7", 0.01, null), (point.Label, point.DeviationMm, point.Limits));
        Assert.True((point.Nominal - new Point3(1, 2 + (0.6 * stock), 3 + (0.8 * stock))).Length < 1e-12);
        Assert.True((point.Actual - new Point3(1, 2 + (0.6 * (stock + 0.01)), 3 + (0.8 * (stock + 0.01)))).Length < 1e-12);
    }

    [Theory]
    [InlineData(0.02, true)]
    [InlineData(0.0199, false)]
    public void Its_limits_are_half_of_the_profile_tolerance_to_either_side(double width, bool isWithin)
    {
        var tolerance = new ProfileTolerance(width, DecisionRule.Simple, IsAligned: false);
        var result = EvaluatedResult.Of(Job, Stock, tolerance, Piece(CuttingStage.Finishing));
        Assert.Equal((-width / 2, width / 2), result.Points[0].Limits);
        Assert.Equal(isWithin, result.IsWithinLimits);
    }

    [Fact]
    public void A_tolerance_of_aligned_points_has_no_limits_for_points_that_are_not() =>
        Assert.Null(EvaluatedResult.Of(
            Job, Stock, new(0.02, DecisionRule.Simple, IsAligned: true), Piece(CuttingStage.Finishing)).IsWithinLimits);

    private static EvaluatedPiece Piece(CuttingStage stage) =>
        new("p.csv", new('1', 64), stage, false, null, [Sample], DeviationStatistics.Of([0.01, 0.02]), []);
}
