using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating.Tests;

/// <summary>The verdict that a setter decides by. L1 has the limits -0.05 and 0.02 of the mating error, L2 the same.</summary>
public sealed class MatchVerdictTests
{
    [Fact]
    public void Points_within_their_limits_are_to_cut()
    {
        var verdict = Of([0.019, -0.049, -0.01, 0]);

        Assert.Equal((VerdictCode.Within, true, 4, 4), (verdict.Code, verdict.IsToCut, verdict.Points, verdict.Within));
        Assert.Equal(("L1", "2", -0.049), (verdict.Worst!.Feature, verdict.Worst.Point, verdict.Worst.MatingErrorMm));
        Assert.Equal(new ToleranceBand(-0.05, 0.02), verdict.Limits);
        Assert.False(verdict.Worst.IsOutside);
        Assert.Null(verdict.WorstBetween);
    }

    [Fact]
    public void A_point_on_its_limit_is_within_and_one_beyond_it_is_outside()
    {
        Assert.Equal(VerdictCode.Within, Of([0.02, -0.05, 0, 0]).Code);

        var verdict = Of([0.0201, -0.0501, 0, 0]);
        Assert.Equal((VerdictCode.Outside, false, 2), (verdict.Code, verdict.IsToCut, verdict.Within));
        Assert.Equal(["1", "2"], verdict.Outside);
        Assert.True(verdict.Worst!.IsOutside);
    }

    [Fact]
    public void A_place_between_the_key_points_can_be_outside_while_they_are_within()
    {
        var verdict = Of([0, 0, 0, 0], worstBetween: -0.06);

        Assert.Equal((VerdictCode.OutsideBetween, false, 4), (verdict.Code, verdict.IsToCut, verdict.Within));
        Assert.Equal(["L1"], verdict.OutsideBetween);
        var worst = verdict.WorstBetween!;
        Assert.Equal((null, 50, -0.06, 1.96 * 0.005), (worst.Point, worst.Place.X, worst.MatingErrorMm, worst.Interval95Mm));
        Assert.Equal(VerdictCode.Within, Of([0, 0, 0, 0], worstBetween: -0.05).Code);
        Assert.Equal(VerdictCode.Outside, Of([0.03, 0, 0, 0], worstBetween: -0.06).Code);
    }

    // A risk of 5 % is a guard band of 1.645 u: with u = 0.005, from -0.04178 to 0.01178.
    [Fact]
    public void A_guard_band_accepts_less_than_the_limits()
    {
        var verdict = Of([0.0118, -0.0417, 0.0117, 0], DecisionRule.GuardBand(5));

        Assert.Equal((VerdictCode.NotAccepted, false, 4), (verdict.Code, verdict.IsToCut, verdict.Within));
        Assert.Equal(["1"], verdict.NotAccepted);
        Assert.Equal(VerdictCode.Within, Of([0.0118, -0.0417, 0.0117, 0], DecisionRule.Simple).Code);
    }

    [Fact]
    public void Guard_bands_that_overlap_accept_nothing() =>
        Assert.Equal(["1", "2", "3", "4"], Of([0, 0, 0, 0], DecisionRule.GuardBand(0.01), u: 0.02).NotAccepted);

    [Fact]
    public void Limits_without_width_are_no_limits_to_be_outside_of()
    {
        var report = Report([0.001, 0, 0, 0], null, 0.005, null);
        var verdict = (report with
        {
            Features = [.. report.Features.Select(f => f with { Tolerance = new(ToleranceBand.Zero, ToleranceSource.Stated) })]
        }).Verdict;

        Assert.Equal((VerdictCode.NoLimits, true, 0, 0), (verdict.Code, verdict.IsToCut, verdict.Points, verdict.Within));
        Assert.Equal(0.001, verdict.Worst!.MatingErrorMm);
        Assert.Null(verdict.Limits);
    }

    [Fact]
    public void Different_limits_are_not_common_ones()
    {
        var report = Report([0, 0, 0, 0], null, 0.005, null);

        Assert.Null((report with
        {
            Features = [report.Features[0], report.Features[1] with { Tolerance = new(new(-1, 1), ToleranceSource.Stated) }]
        }).Verdict.Limits);
    }

    [Fact]
    public void A_proof_that_does_not_hold_comes_first()
    {
        var report = Report([1, 1, 1, 1], null, 0.005, null);

        Assert.Equal(VerdictCode.ProofFails, (report with { Proof = report.Proof with { Holds = false } }).Verdict.Code);
    }

    [Fact]
    public void The_document_begins_with_it()
    {
        var json = JsonNode.Parse(MatchReportJson.Write(Report([0.0201, 0, 0, 0], null, 0.005, 0.004)))!.AsObject();

        Assert.Equal(["schema", "verdict"], json.Select(m => m.Key).Take(2));
        var verdict = json["verdict"]!;
        Assert.Equal("outside-limits", (string?)verdict["code"]);
        Assert.Equal((false, true, 4, 3), (
            (bool)verdict["cut"]!, (bool)verdict["compensated"]!, (int)verdict["points"]!, (int)verdict["pointsWithin"]!));
        Assert.Equal("1", (string?)verdict["outside"]![0]);
        Assert.Equal(("L1", "1", 0.0201, 0.0098), (
            (string?)verdict["worst"]!["feature"],
            (string?)verdict["worst"]!["point"],
            (double)verdict["worst"]!["predictedMm"]!,
            (double)verdict["worst"]!["interval95Mm"]!));
        Assert.Equal(("L1", null, 50.0, 0.004), (
            (string?)verdict["worstBetween"]!["feature"],
            (string?)verdict["worstBetween"]!["point"],
            (double)verdict["worstBetween"]!["place"]!["x"]!,
            (double)verdict["worstBetween"]!["predictedMm"]!));
    }

    [Fact]
    public void A_report_of_an_earlier_version_has_a_verdict_without_intervals_and_probability()
    {
        var json = JsonNode.Parse(MatchReportJson.Write(HandMadeReport.Report))!.AsObject();
        json.Remove("verdict");
        json.Remove("probabilityAfter");
        foreach (var point in json["keyPoints"]!.AsArray())
        {
            point!.AsObject().Remove("probabilityAfter");
            point.AsObject().Remove("interval95Mm");
        }

        var report = MatchReportJson.Read(ReportReader.Document(Encoding.UTF8.GetBytes(json.ToJsonString())));

        Assert.Equal(VerdictCode.Within, report.Verdict.Code);
        Assert.Null(report.Verdict.Worst!.Interval95Mm);
        Assert.Null(report.Verdict.ProbabilityAfter);
        Assert.Null(report.KeyPoints[0].ProbabilityAfter);
    }

    [Fact]
    public void What_is_left_has_a_probability_of_conformance_for_points_features_and_the_pair()
    {
        var report = new MatchCase(Programs.ToolBelow)
        {
            Features = [MatchCase.Line("L1", "N50", "1", "2", """ "toleranceMm": [-0.05, 0.05] """)],
            Theoretical = "1 10 0; 2 40 0",
            Part = "1 10 0.04; 2 40 0.04",
        }.Report();

        Assert.All(report.KeyPoints, p => Assert.Equal(
            Conformance.Probability(new(-0.05, 0.05), p.PredictedMm, p.Interval95Mm!.Value / PredictedError.Factor95)!.Value,
            p.ProbabilityAfter!.Value,
            12));
        Assert.Equal(report.KeyPoints[0].ProbabilityAfter * report.KeyPoints[1].ProbabilityAfter, report.Features[0].ProbabilityAfter);
        Assert.Equal(report.Features[0].ProbabilityAfter, report.ProbabilityAfter);
        Assert.Equal(report.ProbabilityAfter, report.Verdict.ProbabilityAfter);
    }

    private static MatchVerdict Of(double[] left, DecisionRule? rule = null, double u = 0.005, double? worstBetween = null) =>
        Report(left, rule, u, worstBetween).Verdict;

    private static MatchReport Report(double[] left, DecisionRule? rule, double u, double? worstBetween) => HandMadeReport.Report with
    {
        Rule = rule,
        Features = [
            HandMadeReport.Line with
            {
                WorstBetween = worstBetween is { } worst ? new(new(50, 0), new(0, 1), -0.1, worst, u) : null
            },
            HandMadeReport.Calm],
        KeyPoints = [
            .. HandMadeReport.Report.KeyPoints.Zip(
                left, (p, mm) => p with { PredictedMm = mm, Interval95Mm = PredictedError.Factor95 * u })],
    };
}
