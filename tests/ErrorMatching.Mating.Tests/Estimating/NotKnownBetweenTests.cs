using System.Globalization;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

/// <summary>What a verdict says of the boundary between key points that do not tell its form.</summary>
public sealed class NotKnownBetweenTests
{
    private const string Limits = """ "toleranceMm": [-0.01, 0.01] """;
    private const string Two = "1 10 0; 2 40 0", Three = "1 10 0; 3 25 0; 2 40 0";

    [Fact]
    public void Two_points_do_not_tell_how_a_line_bows()
    {
        var report = Line(Two, Limits).Report();
        Assert.Equal((VerdictCode.NotKnownBetween, true), (report.Verdict.Code, report.Verdict.IsToCut));
        Assert.Equal(["L1"], report.Verdict.NotKnownBetween);

        // One more point in the middle would tell most.
        Assert.Equal(new(25, 0), report.Verdict.WorstBetween!.Place, (a, b) => a.DistanceTo(b) < 1e-9);
        Assert.Equal((false, null), (report.Verdict.WorstBetween.IsKnown, report.Verdict.WorstBetween.Interval95Mm));
        Assert.StartsWith("2 of 2 points will be within", VerdictWords.Of(report.Verdict), StringComparison.Ordinal);
        Assert.Contains("nothing is known of L1", VerdictWords.Of(report.Verdict), StringComparison.Ordinal);
        Assert.Contains(
            "between them not known: one more point near X25.000 Y0.000 on L1",
            VerdictWords.Worst(report.Verdict)!,
            StringComparison.Ordinal);

        var json = JsonNode.Parse(MatchReportJson.Write(report))!;
        foreach (var between in new[] { json["verdict"]!["worstBetween"]!, json["features"]![0]!["worstBetween"]! })
        {
            Assert.False(between["known"]!.GetValue<bool>());
            Assert.Null(between["interval95Mm"]);
        }

        Assert.Equal("not-known-between", json["verdict"]!["code"]!.GetValue<string>());
        var again = MatchReportJson.Read(Reporting.ReportReader.Document(MatchReportJson.Write(report)));
        Assert.Equal(VerdictCode.NotKnownBetween, again.Verdict.Code);
    }

    [Fact]
    public void A_job_may_state_the_form()
    {
        var report = Line(Two, Limits + """, "formMm": 0.004 """).Report();
        Assert.Equal(VerdictCode.Within, report.Verdict.Code);
        var between = report.Features[0].WorstBetween!;
        Assert.True(between.IsKnown);

        // The ends are as measured; the middle is off by as much as the form, and hardly correlated with them.
        var estimate = Line(Two, Limits + """, "formMm": 0.004 """).Match();
        Assert.InRange(between.StandardUncertaintyMm, 0, 0.005);
        Assert.Equal(0, estimate.Prediction.Features[0].WorstBetween!.AfterMm, 1e-9);
    }

    // The form of 0.02 mm is at 1.96 times that between points at both of which nothing is off.
    [Fact]
    public void A_bound_beyond_the_limits_is_part_of_the_verdict()
    {
        const string More = Limits + """, "formMm": 0.02 """;
        var verdict = Line(Two, More).Report().Verdict;
        Assert.Equal((VerdictCode.NotKnownBetween, true), (verdict.Code, verdict.IsToCut));
        Assert.Equal(["L1"], verdict.DoubtfulBetween.Select(e => e.Feature));
        Assert.InRange(verdict.DoubtfulBetween[0].BoundMm, 0.02, 0.06);
        Assert.Empty(verdict.NotKnownBetween);
        Assert.Contains(
            $"Between them, L1 may be off by up to {VerdictWords.Bound(verdict.DoubtfulBetween[0]):0.000}. Cut it if",
            VerdictWords.Of(verdict), StringComparison.Ordinal);
        Assert.EndsWith(
            "on L1 near X25.000 Y0.000, where one more point would tell most.", VerdictWords.Worst(verdict)!, StringComparison.Ordinal);

        // With guard bands, it is not for the program to be cut.
        var guarded = Line(Two, More) with { More = """ "decision": { "rule": "guard-band", "riskPercent": 5 }, """ };
        var rule = guarded.Report().Verdict;
        Assert.Equal((VerdictCode.NotAccepted, false), (rule.Code, rule.IsToCut));
        Assert.Equal(["L1"], rule.NotAcceptedBetween);
        Assert.Empty(rule.NotAccepted);
        Assert.Contains("does not accept L1 between the points: too near the limits", VerdictWords.Of(rule), StringComparison.Ordinal);
    }

    // Where the gauge is what leaves it open, a key point has the same risk: more points would not help.
    [Theory]
    [InlineData(0.008, false)]
    [InlineData(0.018, false)]
    [InlineData(0.019, true)]
    public void What_the_gauge_leaves_open_is_no_doubt_about_the_form(double formMm, bool isDoubtful)
    {
        var more = string.Create(CultureInfo.InvariantCulture, $""" "toleranceMm": [-0.0115, 0.0115], "formMm": {formMm} """);
        var verdict = (Line(Two, more) with { Gauge = """ "uncertaintyMm": 0.005 """ }).Report().Verdict;
        Assert.True(verdict.WorstBetween!.MarginMm < verdict.WorstBetween.Interval95Mm);
        Assert.True(isDoubtful == verdict.DoubtfulBetween.Count > 0, $"{verdict.WorstBetween}");
    }

    [Fact]
    public void A_third_point_tells_it()
    {
        var report = Line(Three, Limits).Report();
        Assert.Equal((VerdictCode.Within, true), (report.Verdict.Code, report.Features[0].WorstBetween!.IsKnown));
    }

    [Theory]
    [InlineData(4, "", VerdictCode.NotKnownBetween)]
    [InlineData(5, "", VerdictCode.NotKnownBetween)]
    [InlineData(6, "", VerdictCode.Within)]
    [InlineData(4, """, "formMm": 0.002 """, VerdictCode.Within)]
    public void Four_points_do_not_tell_how_oval_a_circle_is(int points, string more, VerdictCode code)
    {
        var report = Circle(points, _ => 0, more).Report();
        Assert.Equal(code, report.Verdict.Code);
        var between = report.Features[0].WorstBetween!;
        Assert.Equal(code == VerdictCode.Within, between.IsKnown);
        if (code == VerdictCode.NotKnownBetween)
        {
            // Furthest from all points: in the middle between two of them.
            Assert.Equal(20, between.Place.DistanceTo(new(50, 30)), 1e-9);
            Assert.InRange(
                Enumerable.Range(0, points).Min(i => between.Place.DistanceTo(At(points, i, 20))),
                20 * 2 * Math.Sin(Math.PI / points / 2) * 0.9,
                20 * 2 * Math.Sin(Math.PI / points / 2) + 1e-9);
        }
        else if (more.Length > 0)
        {
            Assert.Equal(0.002, between.StandardUncertaintyMm, 1e-6);
        }
    }

    // An oval of 30 um at eight points: with the circle that fits it best, about as much is left between them as at them.
    [Fact]
    public void An_oval_circle_is_uncertain_between_its_points()
    {
        var between = Circle(8, i => i % 4 < 2 ? 0.03 : -0.03, "").Report().Features[0].WorstBetween!;
        Assert.True(between.IsKnown);
        Assert.InRange(between.StandardUncertaintyMm, 0.03, 0.06);
    }

    // The face is 0.35 mm lower than designed, and the chamfer of 0.4 mm at its end is in its place: the chamfer that is left is not
    // where its points are. With the face in its place, too, the chamfer is compared.
    [Theory]
    [InlineData(-0.35, VerdictCode.NotKnownBetween)]
    [InlineData(-0.001, VerdictCode.Within)]
    public void Of_an_element_that_its_neighbor_takes_away_nothing_is_known(double face, VerdictCode code)
    {
        const string Face = "1 10 {0}; 2 25 {0}; 3 40 {0}", Chamfer = "; 4 50.1 -0.1; 5 50.2 -0.2; 6 50.3 -0.3";
        var report = new MatchCase(
            "%\nO1000\nN10 G21 G90 G17\nN20 G0 X0. Y20.\nN30 G1 G41 D1 Y0. F300\nN50 X50.\nN60 X50.4 Y-0.4\nN70 Y-30.\nN80 G40 X90.\n"
                + "N90 M30\n%\n")
        {
            Theoretical = string.Format(CultureInfo.InvariantCulture, Face, 0) + Chamfer,
            Part = string.Format(CultureInfo.InvariantCulture, Face, face) + Chamfer,
            Features = [
                MatchCase.Feature("line", "F1", "N50", """["1..3"]""", """ "toleranceMm": [-0.5, 0.5] """),
                MatchCase.Feature("line", "F2", "N60", """["4..6"]""", Limits)],
        }.Report();
        Assert.Equal(code, report.Verdict.Code);
        Assert.Equal(code == VerdictCode.Within ? [] : ["F2"], report.Verdict.NotKnownBetween);
        Assert.InRange(report.Features[1].WorstBetween!.AfterMm, -0.01, 0.01);
    }

    private static MatchCase Line(string points, string more) => new(Programs.ToolBelow)
    {
        Theoretical = points,
        Part = points,
        Features = [MatchCase.Feature("line", "L1", "N50", points == Two ? """["1", "2"]""" : """["1", "3", "2"]""", more)],
    };

    private static MatchCase Circle(int count, Func<int, double> form, string more) => new(
        "%\nO1000\nN10 G21 G90 G17\nN20 G0 X80. Y30.\nN40 G1 X73. F300\nN50 G2 X27. I-23. J0.\nN60 X73. I23. J0.\n"
            + "N70 G1 X80.\nN90 M30\n%\n")
    {
        Theoretical = Around(count, _ => 0),
        Part = Around(count, form),
        Features = [MatchCase.Feature("circle", "B1", "N50..N60", $"""["1..{count}"]""", """ "toleranceMm": [-0.1, 0.1] """ + more)],
    };

    private static string Around(int count, Func<int, double> form) => string.Join("; ", Enumerable.Range(0, count).Select(
        i => At(count, i, 20 + form(i)) is var p ? string.Create(CultureInfo.InvariantCulture, $"{i + 1} {p.X:R} {p.Y:R}") : ""));

    private static Point2 At(int count, int index, double radius) =>
        new Point2(50, 30) + (radius * Vector2.FromDirection(Angle.FromDegrees(360.0 * index / count)));
}
