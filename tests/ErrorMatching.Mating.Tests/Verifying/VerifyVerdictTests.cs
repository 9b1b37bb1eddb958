using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating.Tests;

/// <summary>The verdict on a measured counterpart. The deviation of the part has the limits -0.02 and 0.05, so its mating error has
/// -0.05 and 0.02. Each point has u = 0.005.</summary>
public sealed class VerifyVerdictTests
{
    private static readonly ToleranceBand Band = new(-0.02, 0.05);

    [Fact]
    public void The_limits_are_those_of_the_mating_error()
    {
        Assert.Equal((VerifyCode.Within, true), (Of([0.02, -0.05]).Code, Of([0.02, -0.05]).IsInTolerance));

        var verdict = Of([0.021, -0.049, 0.04]);

        Assert.Equal((VerifyCode.Outside, false, 3, 1), (verdict.Code, verdict.IsInTolerance, verdict.Points, verdict.Within));
        Assert.Equal(["1", "3"], verdict.Outside);
        Assert.Equal("3", verdict.Tightest!.Point);
        Assert.Equal("2", verdict.Worst.Point);
    }

    // One point on a limit is beyond it with 50 %; another two standard uncertainties inside with 2.275 %.
    [Fact]
    public void The_risk_is_that_of_any_point()
    {
        Assert.Equal(0.5, Of([0.02]).Probability!.Value, 1e-9);
        Assert.Equal(0.5 * (1 - 0.0227501), Of([0.02, 0.01]).Probability!.Value, 1e-6);
        Assert.Equal("Risk that a point is outside its limits: 50.0 %.", VerifyWords.Risk(Of([0.02])));
    }

    // A risk of 5 % is a guard band of 1.645 u: from -0.04178 to 0.01178.
    [Fact]
    public void A_guard_band_accepts_less_than_the_limits()
    {
        var verdict = Of([0.0118, -0.0417, 0], DecisionRule.GuardBand(5));

        Assert.Equal((VerifyCode.Within, false), (verdict.Code, verdict.IsInTolerance));
        Assert.Equal(["1"], verdict.NotAccepted);
        Assert.Equal(
            "3 of 3 points are within -0.05 to +0.02 (worst 0.0417 ± 0.0098), but the decision rule does not accept point 1: too near the "
                + "limit.",
            VerifyWords.Of(verdict));
        Assert.True(Of([0.0117], DecisionRule.GuardBand(5)).IsInTolerance);
    }

    [Fact]
    public void Without_limits_nothing_is_judged()
    {
        var verdict = Report([0.3, -0.1], DecisionRule.Simple, ToleranceBand.Zero).Verdict;

        Assert.Equal((VerifyCode.NoLimits, null, 0), (verdict.Code, verdict.IsInTolerance, verdict.Points));
        Assert.Null(verdict.Probability);
        Assert.Equal(
            "No feature has limits with a width; the worst mating error is 0.3000 ± 0.0098, at point 1.", VerifyWords.Of(verdict));
    }

    [Fact]
    public void The_sentence_names_the_points_and_the_furthest()
    {
        Assert.Equal("1 of 2 points is outside -0.05 to +0.02: point 2, by 0.0100 ± 0.0098.", VerifyWords.Of(Of([0, 0.03])));
        Assert.Equal(
            "2 of 2 points are outside -0.05 to +0.02: points 1 and 2, point 1 the furthest, by 0.0200 ± 0.0098.",
            VerifyWords.Of(Of([-0.07, 0.03])));
    }

    [Fact]
    public void The_document_begins_with_it_and_keeps_it()
    {
        var report = Report([0.03, 0.0118], DecisionRule.GuardBand(5), Band);
        var bytes = VerifyReportJson.Write(report);
        var json = JsonNode.Parse(bytes)!.AsObject();

        Assert.Equal(["schema", "verdict"], json.Select(m => m.Key).Take(2));
        Assert.Equal("outside-limits", (string?)json["verdict"]!["code"]);
        Assert.Equal(["1"], json["verdict"]!["outside"]!.AsArray().Select(p => (string?)p));
        Assert.Equal(["2"], json["verdict"]!["notAccepted"]!.AsArray().Select(p => (string?)p));
        Assert.Equal(VerifyWords.Of(report.Verdict), (string?)json["verdict"]!["sentence"]);
        Assert.Equal(bytes, VerifyReportJson.Write(VerifyReportJson.Read(ReportReader.Document(bytes))));

        // A report of an earlier version states neither rule nor uncertainty.
        json.Remove("decisionRule");
        json.Remove("uncertaintyMm");
        json.Remove("verdict");
        var older = VerifyReportJson.Read(ReportReader.Document(Encoding.UTF8.GetBytes(json.ToJsonString()))).Verdict;
        Assert.Equal((VerifyCode.Outside, null, "1"), (older.Code, older.Probability, Assert.Single(older.Outside)));
    }

    [Fact]
    public void The_page_begins_with_it_in_red_and_has_no_check_mark()
    {
        var page = Encoding.UTF8.GetString(VerifyReportHtml.Write(Report([0.03, 0], DecisionRule.Simple, Band)));

        Assert.Contains("<p id=\"verdict\" class=\"verdict fails\"><strong>✗ 1 of 2 points is outside", page, StringComparison.Ordinal);
        Assert.DoesNotContain("✓", page, StringComparison.Ordinal);
        Assert.Contains(
            "<p id=\"verdict\" class=\"verdict holds\"><strong>✓ 2 of 2 points are within",
            Encoding.UTF8.GetString(VerifyReportHtml.Write(Report([0, 0], DecisionRule.Simple, Band))),
            StringComparison.Ordinal);
    }

    private static VerifyVerdict Of(double[] errors, DecisionRule? rule = null) =>
        Report(errors, rule ?? DecisionRule.Simple, Band).Verdict;

    // Points along x; before, each was off by 0.5.
    private static VerifyReport Report(double[] errors, DecisionRule rule, ToleranceBand band)
    {
        VerifiedPoint[] points = [
            .. errors.Select((e, i) => new VerifiedPoint(
                FormattableString.Invariant($"{i + 1}"), new(i, 0), new(i, 0.5), new(i, e), new(0, 1)))];
        return new(
            HandMadeReport.Report.Job,
            [.. HandMadeReport.Report.Inputs, new("counterpart", "before.csv", "b"), new("counterpart-after", "after.csv", "a")],
            new(points, [VerifiedFeature.DeviationOf("L1", points)])
            {
                Boundaries = [new("L1", band, [.. points.Select(p => (p.Label, p.Part))], [new(0, 0), new(9, 0)])],
            },
            [])
        {
            Rule = rule,
            UncertaintyMm = 0.005,
        };
    }
}
