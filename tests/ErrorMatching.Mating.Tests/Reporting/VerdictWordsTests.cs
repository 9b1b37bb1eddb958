using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

/// <summary>The verdict in words. The limits of the mating error are -0.05 and 0.02, or ±0.05 where a test says so.</summary>
public sealed class VerdictWordsTests
{
    private static readonly ToleranceBand Even = new(-0.05, 0.05);

    [Fact]
    public void Within_equal_limits_it_says_them_with_the_worst_error() => Assert.Equal(
        "4 of 4 points will be within ±0.05 (worst 0.007 ± 0.011). Cut it.",
        Words(Report([0.007, -0.001, 0, 0], 0.0054, Even)));

    [Fact]
    public void Limits_of_different_size_are_said_with_their_signs() => Assert.Equal(
        "4 of 4 points will be within -0.05 to +0.02 (worst 0.0070 ± 0.0039). Cut it.", Words(Report([-0.007, 0, 0, 0], 0.002)));

    [Fact]
    public void Where_features_have_different_limits_the_tightest_point_is_said_with_its_own()
    {
        var report = Report([0.03, 0, 0.018, 0], 0.002, Even);
        report = report with { Features = [report.Features[0], With(report.Features[1], new(-0.02, 0.02))] };

        Assert.Equal(
            "4 of 4 points will be within their limits (tightest 0.0180 ± 0.0039 within ±0.02, at point 3). Cut it.", Words(report));
    }

    [Fact]
    public void Points_outside_are_counted_and_named()
    {
        Assert.Equal(
            "1 of 4 points will be outside ±0.05: point 2, by 0.013 ± 0.011. Do not cut it unless that is acceptable there.",
            Words(Report([0.007, -0.063, 0, 0], 0.0054, Even)));
        Assert.Equal(
            "2 of 4 points will be outside ±0.05: points 2 and 3, point 2 the furthest, by 0.013 ± 0.011. Do not cut it unless that is "
                + "acceptable there.",
            Words(Report([0.007, -0.063, 0.051, 0], 0.0054, Even)));
    }

    [Fact]
    public void A_place_between_the_points_is_said_even_if_all_points_are_within()
    {
        Assert.Equal(
            "4 of 4 points will be within ±0.05 (worst 0.007 ± 0.011), but L1 will be outside between them. Do not cut it unless that is "
                + "acceptable there.",
            Words(Between(Report([0.007, 0, 0, 0], 0.0054, Even), 0.06)));
        Assert.Equal(
            "1 of 4 points will be outside ±0.05: point 1, by 0.020 ± 0.011. So will L1 between the points. Do not cut it unless that is "
                + "acceptable there.",
            Words(Between(Report([0.07, 0, 0, 0], 0.0054, Even), 0.06)));
    }

    [Fact]
    public void A_program_that_stays_as_it_is_is_said_to()
    {
        var report = Report([0.007, 0, 0, 0], 0.0054, Even) with { Program = new("a.nc", "", 0, 0, []) };
        report = report with { Proof = report.Proof with { Marker = null } };

        Assert.Equal(
            "4 of 4 points will be within ±0.05 (worst 0.007 ± 0.011). Nothing is compensated: the program stays as it is. Cut it.",
            Words(report));
    }

    [Fact]
    public void A_point_in_the_guard_band_is_not_accepted() => Assert.Equal(
        "4 of 4 points will be within ±0.05 (worst 0.045 ± 0.011), but the decision rule does not accept point 1: too near the limit. Do "
            + "not cut it unless you accept the risk.",
        Words(Report([0.045, 0, 0, 0], 0.0054, Even) with { Rule = DecisionRule.GuardBand(5) }));

    [Fact]
    public void Without_limits_the_worst_error_is_said() => Assert.Equal(
        "No feature has limits with a width; the worst error left will be 0.001 ± 0.011. Cut it.",
        Words(Report([0.001, 0, 0, 0], 0.0054, ToleranceBand.Zero)));

    [Fact]
    public void A_proof_that_does_not_hold_is_all_there_is_to_say()
    {
        var report = Report([0, 0, 0, 0], 0.0054);

        Assert.Equal(
            "The proof of the program does not hold. Do not use it.", Words(report with { Proof = report.Proof with { Holds = false } }));
    }

    [Fact]
    public void A_point_that_stands_out_is_named() => Assert.StartsWith(
        "Point 9 of C1 does not fit the others", VerdictWords.Suspects([new("9", "C1", 0.2, 20)]), StringComparison.Ordinal);

    [Fact]
    public void The_risk_is_said_with_the_one_without_compensation()
    {
        var report = Report([0, 0, 0, 0], 0.0054) with { ProbabilityBefore = 0.02, ProbabilityAfter = 0.995 };

        Assert.Equal("Risk that a point will be outside its limits: 0.5 % (without compensation: 98.0 %).", VerdictWords.Risk(report));
        Assert.Null(VerdictWords.Risk(report with { ProbabilityAfter = null }));
    }

    [Fact]
    public void The_worst_place_between_the_points_is_named()
    {
        Assert.Equal(
            "Worst at the points: +0.0070 ± 0.0106 mm at point 1 of L1; between them: -0.0200 ± 0.0106 mm on L1 near X50.000 Y0.000.",
            VerdictWords.Worst(Between(Report([0.007, 0, 0, 0], 0.0054), -0.02).Verdict));
        Assert.Equal(
            "Worst at the points: +0.0070 ± 0.0106 mm at point 1 of L1.", VerdictWords.Worst(Report([0.007, 0, 0, 0], 0.0054).Verdict));
    }

    [Fact]
    public void The_page_begins_with_the_verdict_and_points_to_the_warnings()
    {
        var page = PageReader.Read(MatchReportHtml.Write(Report([0.007, 0, 0, 0], 0.0054, Even)));

        var first = page.Element("body")!.Element("header")!.Elements().First();
        Assert.Equal("verdict", (string?)first.Attribute("id"));
        Assert.Equal("✓ 4 of 4 points will be within ±0.05 (worst 0.007 ± 0.011). Cut it.", first.Element("strong")!.Value);
        Assert.Equal("Read the warning first.", first.Element("a")!.Value);
        Assert.True(first.HasClass("holds"));
        Assert.Equal(
            ["pictures", "summary", "decisions", "key-points", "quantities", "proof"],
            page.Descendants("section").Select(s => (string?)s.Attribute("id")).Take(6));
        Assert.StartsWith(
            "Decide whether to cut: ",
            PageReader.Read(MatchReportHtml.Write(Between(Report([0, 0, 0, 0], 0.0054, Even), 0.06))).ById("summary").Element("ol")!.Value
                .TrimStart(),
            StringComparison.Ordinal);
        Assert.True(
            PageReader.Read(MatchReportHtml.Write(Report([0.07, 0, 0, 0], 0.0054, Even))).ById("verdict").HasClass("fails"));
    }

    private static string Words(MatchReport report) => VerdictWords.Of(report.Verdict);

    private static ReportFeature With(ReportFeature feature, ToleranceBand limits) =>
        feature with { Tolerance = new(limits, ToleranceSource.Stated) };

    private static MatchReport Between(MatchReport report, double worst) => report with
    {
        Features = [report.Features[0] with { WorstBetween = new(new(50, 0), new(0, 1), -0.1, worst, 0.0054) }, report.Features[1]]
    };

    private static MatchReport Report(double[] left, double u, ToleranceBand? limits = null) => HandMadeReport.Report with
    {
        Features = [
            .. HandMadeReport.Report.Features.Select(f => limits is { } band ? With(f, band) : f)],
        KeyPoints = [
            .. HandMadeReport.Report.KeyPoints.Zip(
                left, (p, mm) => p with { PredictedMm = mm, Interval95Mm = PredictedError.Factor95 * u })],
    };
}
