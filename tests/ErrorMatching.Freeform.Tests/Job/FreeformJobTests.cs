using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class FreeformJobTests
{
    [Fact]
    public void Template_is_the_job_of_the_paper()
    {
        var job = Parse(FreeformTemplate.Text);

        Assert.Equal(new JobStock(0.4, 0.2), job.Stock);
        Assert.Equal(new JobTool(6, 2, 10000, 1200), job.Tool);
        Assert.Equal(
            (7, 10, 6.0, 2.0),
            (job.Measuring.Curves, job.Measuring.PointsPerCurve, job.Measuring.StylusDiameterMm, job.Measuring.ApproachMm));
        Assert.Equal((CuttingStage.SemiFinishing, false), (job.Measuring.After, job.Measuring.ReportsStylusCenter));
        Assert.Equal(new JobFit(FitMethod.Best, true, 0.001), job.Fit);
        Assert.Equal(
            (true, false, 0.001, 0.001, false),
            (job.Toolpath.AlongU, job.Toolpath.Zigzag, job.Toolpath.ScallopMm, job.Toolpath.ChordMm, job.Toolpath.ProgramsTip));
        Assert.Equal(new JobMirror(true, 1, 0.2), job.Compensation);
        Assert.True(job.Surface.OutsideIsUp);
    }

    [Fact]
    public void What_a_job_does_not_say_is_what_the_contract_says()
    {
        var job = Parse("""
            {
              "kind": "freeform", "name": "n", "surface": "s.csv", "outside": "-z", "surfaceEntity": 2,
              "tool": { "kind": "ball", "diameterMm": 6 }, "spindleRpm": 1, "feedMmPerMin": 1,
              "measuring": { "curves": 7, "points": 68, "stylusDiameterMm": 6, "dialect": "fanuc", "reports": "stylus-center", "measuredAfter": "finishing" },
              "toolpath": { "dialect": "fanuc", "programs": "tip", "direction": "v", "passes": "zigzag" },
              "fit": { "of": "points", "method": "through-curve-mesh" }, "compensation": { "method": "tool-radius", "gain": 0.5 }
            }
            """);

        Assert.Equal(JobStock.Default, job.Stock);
        Assert.Equal(("2", false), (job.Surface.Entity, job.Surface.OutsideIsUp));
        Assert.Equal(
            (68, null, CuttingStage.Finishing, true),
            (job.Measuring.Points, job.Measuring.PointsPerCurve, job.Measuring.After, job.Measuring.ReportsStylusCenter));
        Assert.Equal((false, true, true), (job.Toolpath.AlongU, job.Toolpath.Zigzag, job.Toolpath.ProgramsTip));
        Assert.Equal(new JobFit(FitMethod.ThroughCurveMesh, false, 0.001), job.Fit);
        Assert.Equal(new JobMirror(false, 0.5, 0.2), job.Compensation);
    }

    [Fact]
    public void A_job_without_a_tolerance_judges_nothing() => Assert.Null(Parse(FreeformTemplate.Text).Profile);

    [Theory]
    [InlineData("", "", null, false)]
    [InlineData(", \"decision\": { \"rule\": \"simple\" }", "", null, false)]
    [InlineData(", \"decision\": { \"rule\": \"guard-band\" }", "", 5.0, false)]
    [InlineData(", \"decision\": { \"rule\": \"guard-band\", \"riskPercent\": 1 }", "\"alignment\": \"best-fit\",", 1.0, true)]
    public void A_profile_tolerance_has_a_zone_a_rule_and_the_alignment_of_the_measuring(
        string decision, string alignment, double? risk, bool isAligned)
    {
        var profile = Parse(WithProfile("0.02" + decision, alignment)).Profile!;
        Assert.Equal((0.02, risk, isAligned), (profile.WidthMm, profile.Rule.RiskPercent, profile.IsAligned));
        Assert.Equal(new ToleranceBand(-0.01, 0.01), profile.Limits);
    }

    // limitMm is 0.2, u as stated; the guard bands of 5 % are 1.644854 u wide each.
    [Theory]
    [InlineData("0.4", "", null, "")]
    [InlineData("0.41", "", "limit-implausible", "at most 0.4 mm, twice compensation.limitMm")]
    [InlineData("20", "", "limit-implausible", "µm? 20 µm are 0.02 mm")]
    [InlineData("0.02", "\"uncertaintyMm\": 0.01,", null, "")]
    [InlineData("0.02", "\"uncertaintyMm\": 0.010001,", "gauge-too-coarse", "at least 0.020002 mm")]
    [InlineData("0.0329, \"decision\": { \"rule\": \"guard-band\" }", "\"uncertaintyMm\": 0.01,", null, "")]
    [InlineData(
        "0.0328, \"decision\": { \"rule\": \"guard-band\" }", "\"uncertaintyMm\": 0.01,", "guard-bands-overlap", "at least 0.032898 mm")]
    public void A_profile_tolerance_that_judges_nothing_is_refused(string tolerance, string measuring, string? code, string expected)
    {
        if (code is null)
        {
            Assert.NotNull(Parse(WithProfile(tolerance, measuring)).Profile);
            return;
        }

        var problem = Assert.Single(Assert.Throws<InputException>(() => Parse(WithProfile(tolerance, measuring))).Refusals);
        Assert.Equal((code, "$.profileToleranceMm"), (problem.Code, problem.Place.Path));
        Assert.Contains(expected, problem.Expected, StringComparison.Ordinal);
    }

    private static string WithProfile(string tolerance, string measuring) => FreeformTemplate.Text
        .Replace("\"fit\":", $"\"profileToleranceMm\": {tolerance}, \"fit\":", StringComparison.Ordinal)
        .Replace("\"approachMm\": 2", measuring + "\"approachMm\": 2", StringComparison.Ordinal);

    [Fact]
    public void A_mating_job_is_one_problem_that_says_which_verb_it_belongs_to()
    {
        var error = Assert.Throws<InputException>(() => Parse("""{ "name": "n", "kind": "mating", "part": {} }"""));
        Assert.Equal((FreeformJob.OtherKind, "$.kind", 1, 24), (error.Code, error.Place.Path, error.Place.Line, error.Place.Column));
        Assert.Contains("errormatch match and verify", Assert.Single(error.Refusals).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_files_of_a_gauge_are_described_as_in_mating()
    {
        var job = Parse(FreeformTemplate.Text.Replace(
            "\"measuring\": {",
            """
            "gauge": { "format": { "delimiter": ";", "decimalComma": true, "unit": "inch", "columns": { "label": "Nr" } } },
            "measuring": {
            """,
            StringComparison.Ordinal));
        var format = job.Measuring.Format;
        Assert.Equal((';', true, LengthUnit.Inch), (format.Delimiter, format.DecimalComma, format.Unit));
        var onlyCommas = Parse(FreeformTemplate.Text.Replace(
            "\"measuring\": {", "\"gauge\": { \"format\": { \"decimalComma\": true } }, \"measuring\": {", StringComparison.Ordinal));
        Assert.Equal(MeasurementFormat.Recognized with { DecimalComma = true }, onlyCommas.Measuring.Format);
        Assert.Equal(MeasurementFormat.Recognized, Parse(FreeformTemplate.Text).Measuring.Format);
    }

    [Theory]
    [InlineData("\"format\": \"table\"", "bad-format", "$.gauge.format")]
    [InlineData("\"format\": { \"delimiter\": \"#\" }", "bad-format", "$.gauge.format.delimiter")]
    [InlineData("\"format\": { \"columns\": { \"label\": true } }", "bad-format", "$.gauge.format.columns.label")]
    [InlineData("\"formt\": \"points\"", "unknown-key", "$.gauge.formt")]
    public void A_wrong_description_of_a_gauge_s_files_is_named_by_its_path(string gauge, string code, string path)
    {
        var error = Assert.Throws<InputException>(() => Parse(FreeformTemplate.Text.Replace(
            "\"measuring\": {", "\"gauge\": { " + gauge + " }, \"measuring\": {", StringComparison.Ordinal)));
        Assert.Equal((code, path), (error.Code, error.Place.Path));
        Assert.True(error.Place.Line > 0 && error.Place.Column > 0);
    }

    // Speeds, feeds and lengths that no machine has: written, they would round to 0 or be words of hundreds of digits.
    [Theory]
    [InlineData("\"spindleRpm\": 10000", "\"spindleRpm\": 0.3", "too-small", "$.spindleRpm", "at least 1")]
    [InlineData("\"spindleRpm\": 10000", "\"spindleRpm\": 1e300", "too-large", "$.spindleRpm", "at most 500000")]
    [InlineData("\"feedMmPerMin\": 1200", "\"feedMmPerMin\": 0.0001", "too-small", "$.feedMmPerMin", "at least 0.1")]
    [InlineData("\"feedMmPerMin\": 1200", "\"feedMmPerMin\": 1e7", "too-large", "$.feedMmPerMin", "at most 1000000")]
    [InlineData("\"approachMm\": 2", "\"feedMmPerMin\": 0.00001", "too-small", "$.measuring.feedMmPerMin", "at least 0.1")]
    [InlineData("\"approachMm\": 2", "\"approachMm\": 0.001", "too-small", "$.measuring.approachMm", "at least 0.01")]
    [InlineData("\"approachMm\": 2", "\"overtravelMm\": 1e5", "too-large", "$.measuring.overtravelMm", "at most 1000")]
    [InlineData("\"approachMm\": 2", "\"clearanceMm\": 1e9", "too-large", "$.measuring.clearanceMm", "at most 1000")]
    [InlineData("\"stylusDiameterMm\": 6", "\"stylusDiameterMm\": 1e-5", "too-small", "$.measuring.stylusDiameterMm", "at least 0.01")]
    [InlineData("\"diameterMm\": 6", "\"diameterMm\": 1e9", "too-large", "$.tool.diameterMm", "at most 500")]
    [InlineData("\"diameterMm\": 6", "\"diameterMm\": 1e-4", "too-small", "$.tool.diameterMm", "at least 0.01")]
    [InlineData("\"roughing\": 0.4", "\"roughing\": 1e6", "too-large", "$.stockMm.roughing", "at most 1000")]
    [InlineData("\"limitMm\": 0.2", "\"limitMm\": 1e6", "too-large", "$.compensation.limitMm", "at most 1000")]
    public void What_no_machine_does_is_refused_with_its_limit(string old, string text, string code, string path, string expected)
    {
        Assert.Contains(old, FreeformTemplate.Text, StringComparison.Ordinal);
        var problem = Assert.Single(
            Assert.Throws<InputException>(() => Parse(FreeformTemplate.Text.Replace(old, text, StringComparison.Ordinal))).Refusals);

        Assert.Equal((code, path, expected), (problem.Code, problem.Place.Path, problem.Expected));
        Assert.Contains(text.Split(' ')[1], problem.Found, StringComparison.Ordinal);
    }

    // Lines of points, and a surface through all of them, have no place for a point that is not there.
    [Theory]
    [InlineData("\"method\": \"best\", \"of\": \"error\"", null)]
    [InlineData("\"method\": \"tensor\", \"of\": \"error\"", "points-left-out")]
    [InlineData("\"method\": \"best\", \"of\": \"points\"", "points-left-out")]
    public void A_point_can_be_taken_out_where_the_fit_needs_no_grid(string fit, string? code)
    {
        var text = FreeformTemplate.Text
            .Replace("\"pointsPerCurve\": 10,", "\"pointsPerCurve\": 10, \"without\": [9, 7, 9],", StringComparison.Ordinal)
            .Replace("\"method\": \"best\", \"of\": \"error\"", fit, StringComparison.Ordinal);
        Assert.Contains(fit, text, StringComparison.Ordinal);
        if (code is null)
        {
            Assert.Equal([7, 9], Parse(text).Measuring.Without);
            return;
        }

        var problem = Assert.Single(Assert.Throws<InputException>(() => Parse(text)).Refusals);
        Assert.Equal((code, "$.measuring.without[0]"), (problem.Code, problem.Place.Path));
    }

    [Theory]
    [InlineData("\"curves\": 7, \"pointsPerCurve\": 10,", "", "points-missing", "$.measuring")]
    [InlineData(
        "\"pointsPerCurve\": 10,",
        "\"pointsPerCurve\": 10, \"reconstructionErrorMm\": 0.001,",
        "points-twice",
        "$.measuring.reconstructionErrorMm")]
    [InlineData("\"pointsPerCurve\": 10,", "\"pointsPerCurve\": 10, \"points\": 70,", "points-twice", "$.measuring.points")]
    [InlineData("\"pointsPerCurve\": 10,", "\"points\": 10,", "too-few-points", "$.measuring.points")]
    [InlineData("\"roughing\": 0.4", "\"roughing\": 0.1", "stock-grows", "$.stockMm.roughing")]
    [InlineData("\"method\": \"best\"", "\"method\": \"nurbs\"", "not-one-of", "$.fit.method")]
    [InlineData("\"diameterMm\": 6", "\"diameterMm\": 0", "too-small", "$.tool.diameterMm")]
    [InlineData("\"chordMm\": 0.001", "\"chordMm\": 5", "too-large", "$.toolpath.chordMm")]
    [InlineData("\"scallopMm\": 0.001", "\"scalopMm\": 0.001", "unknown-key", "$.toolpath.scalopMm")]
    public void What_is_wrong_is_named_by_its_path(string old, string text, string code, string path)
    {
        Assert.Contains(old, FreeformTemplate.Text, StringComparison.Ordinal);
        var problem = Assert.Single(
            Assert.Throws<InputException>(() => Parse(FreeformTemplate.Text.Replace(old, text, StringComparison.Ordinal))).Refusals);

        Assert.Equal((code, path), (problem.Code, problem.Place.Path));
    }

    private static FreeformJob Parse(string text) => FreeformJob.Parse(Encoding.UTF8.GetBytes(text), "job.json");
}
