using System.Globalization;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

/// <summary>What is cut against what fits: the gap that a job wants, and what the program does differently from the theoretical
/// outline.</summary>
public sealed class GapAndBaseTests
{
    private const string Gap = """ "toleranceMm": [-0.01, 0.01], "gapMm": """, Limits = """ "toleranceMm": [-0.01, 0.01] """;
    private const string Correct = Limits + """ , "base": "correct" """;

    // The material is above the boundary at y = 0, the tool's center 3 mm below it: a gap takes material away, a press fit leaves more.
    [Theory]
    [InlineData(0.02, "-2.98")]
    [InlineData(-0.015, "-3.015")]
    public void The_wanted_gap_is_cut(double gap, string y)
    {
        var match = Line(0, 0, Gap + Number(gap));
        Assert.Equal([$"N40 G1 X0. Y{y} F300"], match.Changed());
        var feature = match.Report().Features[0];
        Assert.Equal((gap, false), (feature.GapMm, feature.CorrectsBase));
        Assert.Equal(0, feature.BaseMm!.Value, 1e-9);
        Assert.All(match.Report().KeyPoints, p => Assert.Equal((gap, 0), (p.UncompensatedMm, p.PredictedMm), Close));
    }

    [Fact]
    public void A_gap_and_a_deviation_add_up()
    {
        // The part stands 0.05 mm toward the tool; with a gap of 0.02 the boundary follows by 0.03.
        var match = Line(0, -0.05, Gap + "0.02");
        Assert.Equal(["N40 G1 X0. Y-3.03 F300"], match.Changed());
        Assert.All(match.Report().KeyPoints, p => Assert.Equal((-0.03, 0), (p.UncompensatedMm, p.PredictedMm), Close));
    }

    [Fact]
    public void What_the_program_does_differently_stays_and_is_counted()
    {
        // The outline is 0.3 mm above what the program cuts: it leaves too much. Part and outline agree.
        var report = Line(0.3, 0.3, Limits).Report();
        Assert.True(report.IsUnchanged);
        Assert.Equal(0.3, report.Features[0].BaseMm!.Value, 1e-9);
        Assert.All(report.KeyPoints, p => Assert.Equal((0.3, 0.3), (p.UncompensatedMm, p.PredictedMm), Close));
        Assert.Equal(0.3, report.Features[0].WorstBetween!.AfterMm, 1e-9);
        Assert.False(report.Verdict.IsToCut);
        Assert.Equal(["L1", "+0.300"], Assert.Single(report.Warnings, w => w.Code == "base-differs").Values);
    }

    [Fact]
    public void What_the_program_does_differently_is_corrected_if_the_job_asks()
    {
        // The part stands 0.05 mm toward the tool of an outline that is 0.3 mm above the cut.
        var match = Line(0.3, 0.25, Correct);
        Assert.Equal(["N40 G1 X0. Y-2.75 F300"], match.Changed());
        var report = match.Report();
        Assert.Equal(0.3, report.Features[0].BaseMm!.Value, 1e-9);
        Assert.All(report.KeyPoints, p => Assert.Equal((0.25, 0), (p.UncompensatedMm, p.PredictedMm), Close));
        Assert.Equal(0, report.Features[0].WorstBetween!.AfterMm, 1e-9);
        Assert.DoesNotContain(report.Warnings, w => w.Code == "base-differs");

        // The same part about the outline that the program cuts needs the same program.
        Assert.Equal(["N40 G1 X0. Y-2.75 F300"], Line(0, 0.25, Limits).Changed());
    }

    // Under G41 the path is the boundary; the material is below.
    [Theory]
    [InlineData(Limits, 0.04, 0.04)]
    [InlineData(Correct, 0.04, 0)]
    public void Under_cutter_compensation_it_is_the_same(string more, double before, double after)
    {
        var match = new MatchCase(Programs.CompensatedLeft)
        {
            Theoretical = "1 10 -0.04; 2 40 -0.04",
            Part = "1 10 -0.04; 2 40 -0.04",
            Features = [MatchCase.Line("L1", "N50", "1", "2", more)],
        };
        Assert.All(match.Report().KeyPoints, p => Assert.Equal((before, after), (p.UncompensatedMm, p.PredictedMm), Close));
        Assert.Equal(0.04, match.Report().Features[0].BaseMm!.Value, 1e-9);
    }

    // In feedback the measured counterpart has whatever its program did differently.
    [Fact]
    public void In_feedback_the_base_is_part_of_what_was_measured()
    {
        var match = Line(0.3, 0.3, Limits) with
        {
            Counterpart = "1 10 0; 2 40 0",
            Compensation = """{ "from": "counterpart" }""",
        };
        Assert.Equal(["N40 G1 X0. Y-2.7 F300"], match.Changed());
        Assert.Null(match.Report().Features[0].BaseMm);
        Assert.All(match.Report().KeyPoints, p => Assert.Equal((0.3, 0), (p.UncompensatedMm, p.PredictedMm), Close));
    }

    // A boss of radius 20: the seat has the air that the radii leave.
    [Theory]
    [InlineData(20, 20, "", 0)]
    [InlineData(20, 20, """, "gapMm": 0.02""", 0.02)]
    [InlineData(20, 20, """, "gapMm": -0.015""", -0.015)]
    [InlineData(20.05, 20.05, "", 0.05)]
    [InlineData(20.05, 20.05, """, "base": "correct" """, 0)]
    [InlineData(20.05, 20.08, """, "base": "correct", "gapMm": 0.01""", 0.01)]
    public void The_pair_has_the_gap_and_the_base(double theoretical, double part, string more, double air)
    {
        var match = new MatchCase(
            "%\nO1000\nN10 G21 G90 G17\nN20 G0 X80. Y30.\nN40 G1 X73. F300\nN50 G2 X27. I-23. J0.\nN60 X73. I23. J0.\n"
                + "N70 G1 X80.\nN90 M30\n%\n")
        {
            Theoretical = Around(theoretical),
            Part = Around(part),
            Features = [MatchCase.Feature("circle", "B1", "N50..N60", """["1..8"]""", """ "toleranceMm": [-0.005, 0.005] """ + more)],
        };
        Assert.Equal(air, match.Match().Pair!.TightestMm!.Value, 6e-4);
    }

    [Fact]
    public void A_verified_error_is_less_the_gap()
    {
        var point = new VerifiedPoint("1", new(0, 0), new(0, 0.01), new(0, -0.02), new(0, 1)) { GapMm = 0.02 };
        Assert.Equal((0.03, 0), (point.BeforeError.NormalMm, point.AfterError.NormalMm), Close);
    }

    [Fact]
    public void The_report_reads_back_what_it_says_of_gap_and_base()
    {
        var json = MatchReportJson.Write(Line(0.3, 0.3, Correct + """, "gapMm": 0.01""").Report());
        var feature = JsonNode.Parse(json)!["features"]![0]!;
        Assert.Equal(0.01, feature["gapMm"]!.GetValue<double>());
        Assert.Equal("correct", feature["base"]!.GetValue<string>());
        Assert.Equal(0.3, feature["baseMm"]!.GetValue<double>(), 1e-9);
        Assert.Equal(
            json, MatchReportJson.Write(MatchReportJson.Read(ErrorMatching.Reporting.ReportReader.Document(json))));
    }

    [Theory]
    [InlineData(""", "gapMm": "none" """, "$.features[0].gapMm")]
    [InlineData(""", "gapMm": 20""", "$.features[0].gapMm")]
    [InlineData(""", "base": "drop" """, "$.features[0].base")]
    public void Bad_keys_are_refused_at_their_place(string more, string path)
    {
        var refused = Assert.Throws<Refusals.InputException>(() => Line(0, 0, Limits + more).Job);
        Assert.Equal(path, refused.Refusals[0].Place.Path);
    }

    private static MatchCase Line(double theoretical, double part, string more) => new(Programs.ToolBelow)
    {
        Theoretical = $"1 10 {Number(theoretical)}; 2 40 {Number(theoretical)}",
        Part = $"1 10 {Number(part)}; 2 40 {Number(part)}",
        Features = [MatchCase.Line("L1", "N50", "1", "2", more)],
    };

    private static string Around(double radius) => string.Join("; ", Enumerable.Range(0, 8).Select(i =>
    {
        var place = new Point2(50, 30) + (radius * Vector2.FromDirection(Angle.FromDegrees(45 * i)));
        return $"{i + 1} {Number(place.X)} {Number(place.Y)}";
    }));

    private static string Number(double value) => value.ToString("R", CultureInfo.InvariantCulture);

    private static bool Close((double, double) a, (double, double) b) =>
        Math.Abs(a.Item1 - b.Item1) < 5.1e-4 && Math.Abs(a.Item2 - b.Item2) < 5.1e-4;
}
