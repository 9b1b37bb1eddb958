namespace ErrorMatching.Freeform.Tests;

public sealed class SurfaceEvaluationTests
{
    [Fact]
    public void Replicas_are_evaluated_one_by_one_and_together()
    {
        var piece = new MeasuredDesign(PaperDesign.Two);
        var e = SurfaceEvaluation.Evaluate(piece.Job, piece.Surface, [piece.With((u, v) => 0.010), piece.With((u, v) => 0.020)]);

        Assert.Equal([0.010, 0.020], e.Pieces.Select(p => Math.Round(p.Statistics.MeanMm, 9)));
        Assert.Equal(140, e.Together.Count);
        Assert.Equal(0.015, e.Together.MeanMm, 9);
        Assert.Equal(0.005 * Math.Sqrt(140.0 / 139), e.Together.StandardDeviationMm, 9);
        Assert.Equal((0.040, 0.010), (Math.Round(e.Together.ProfileIsoMm, 9), Math.Round(e.Together.ProfileRangeMm, 9)));
        Assert.Equal(0, e.RangeOfStandardDeviationsMm, 9);
    }

    [Theory]
    [InlineData("semi-finishing", 0.2, CuttingStage.SemiFinishing, false)]
    [InlineData("semi-finishing", 0, CuttingStage.Finishing, true)]
    [InlineData("finishing", 0, CuttingStage.Finishing, false)]
    [InlineData("finishing", 0.2, CuttingStage.SemiFinishing, true)]
    public void Points_tell_whether_stock_lies_on_the_piece(string job, double stock, CuttingStage stage, bool isFound)
    {
        var piece = new MeasuredDesign(PaperDesign.Three, "\"measuredAfter\": \"semi-finishing\"", $"\"measuredAfter\": \"{job}\"");
        var e = SurfaceEvaluation.Evaluate(piece.Job, piece.Surface, [piece.Over(stock, (u, v) => 0.015 + (0.01 * u))]).Pieces[0];

        Assert.Equal((stage, isFound), (e.Stage, e.StageIsFound));
        Assert.Equal(0.02, e.Statistics.MeanMm, 2);
    }

    [Fact]
    public void A_piece_that_lies_at_no_stage_s_surface_is_held_against_the_job_s()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var e = SurfaceEvaluation.Evaluate(piece.Job, piece.Surface, [piece.Over(0.09, (u, v) => 0)]).Pieces[0];

        Assert.False(e.StageIsFound);
        Assert.Equal(-0.11, e.Statistics.MeanMm, 9);
    }

    [Fact]
    public void A_point_that_is_not_what_those_around_it_say_is_named_and_counts()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var bad = piece.Plan.Points[31];
        var e = SurfaceEvaluation.Evaluate(
            piece.Job,
            piece.Surface,
            [piece.With((u, v) => 0.01 * u, "good.csv"), piece.With((u, v) => u == bad.U && v == bad.V ? 0.48 : 0.01 * v, "bad.csv")]);

        Assert.Empty(e.Pieces[0].Warnings);
        var warning = Assert.Single(e.Pieces[1].Warnings);
        Assert.Equal("outlying-point-measured", warning.Code);
        Assert.StartsWith($"bad.csv: Point {bad.Number} (near ", warning.Message, StringComparison.Ordinal);
        Assert.Contains("is +480.0 µm off", warning.Message, StringComparison.Ordinal);
        Assert.Equal(0.96, e.Together.ProfileIsoMm, 9);
    }
}
