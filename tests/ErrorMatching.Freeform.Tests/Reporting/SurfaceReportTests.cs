using System.Text;
using System.Text.Json;
using System.Xml.Linq;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Freeform.Tests;

public sealed class SurfaceReportTests
{
    internal static readonly MeasuredDesign Piece = new(
        PaperDesign.Two, "\"scallopMm\": 0.001, \"chordMm\": 0.001", "\"scallopMm\": 0.1, \"chordMm\": 0.02");
    internal static readonly CompensationReport Report = Make("Surface <two> & co.");

    [Fact]
    public void Compensation_has_what_scripts_read()
    {
        using var json = JsonDocument.Parse(CompensationDocument.Of(Report).Write());
        var root = json.RootElement;

        Assert.Equal("errormatch/surface-compensate/1", root.GetProperty("schema").GetString());
        Assert.Equal(17, root.GetProperty("before").GetProperty("meanUm").GetDouble(), 0);
        Assert.Equal("systematic", root.GetProperty("structure").GetProperty("verdict").GetString());
        Assert.Equal(70, root.GetProperty("points").GetArrayLength());
        Assert.Equal(1000 * Report.Result.Samples[3].ErrorMm, root.GetProperty("points")[3].GetProperty("errorUm").GetDouble(), 6);
        Assert.InRange(root.GetProperty("toolpath").GetProperty("scallopUm").GetDouble(), 50, 100);
        Assert.True(
            root.GetProperty("predicted")
                .GetProperty("toolRadius")
                .GetProperty("standardDeviationUm")
                .GetDouble() > root
                .GetProperty("predicted")
                .GetProperty("mirror")
                .GetProperty("standardDeviationUm")
                .GetDouble());
    }

    [Fact]
    public void A_compensation_is_read_as_it_was_written() =>
        DocumentCheck.IsReadAndWritten(CompensationDocument.Of(Report).Write(), StoredSurfaceTests.Again);

    [Fact]
    public void A_map_has_the_field_and_what_either_way_leaves_of_it()
    {
        using var json = JsonDocument.Parse(CompensationDocument.Of(Report).Write());
        var (map, result) = (json.RootElement.GetProperty("map"), Report.Result);
        var (countU, countV) = (map.GetProperty("countU").GetInt32(), map.GetProperty("countV").GetInt32());
        double[] Values(string name) => [.. map.GetProperty(name).EnumerateArray().Select(v => v.GetDouble())];
        var (x, y, error, mirror, radius) = (Values("x"), Values("y"), Values("errorUm"), Values("mirrorUm"), Values("toolRadiusUm"));
        var spline = result.Input.Surface.Spline;
        foreach (var (i, j) in new[] { (0, 0), (countU - 1, 0), (0, countV - 1), (countU - 1, countV - 1), (countU / 2, countV / 2) })
        {
            var (u, v, n) = (Along(spline.KnotsU, i, countU), Along(spline.KnotsV, j, countV), (i * countV) + j);
            var place = spline.PointAt(u, v);
            Assert.Equal(
                (place.X, place.Y), (x[n], y[n]), (a, b) => Math.Abs(a.Item1 - b.Item1) < 1e-8 && Math.Abs(a.Item2 - b.Item2) < 1e-8);
            Assert.Equal(1000 * result.Systematic.At(u, v), error[n], 6);
            Assert.Equal(error[n] - (1000 * result.Before.MeanMm), radius[n], 6);
        }

        // A gain of one leaves nothing of what is known.
        Assert.Equal(countU * countV, mirror.Length);
        Assert.All(mirror, m => Assert.Equal(0, m, 6));
        Assert.Empty(Values("outside"));

        static double Along(KnotVector knots, int i, int count) => knots.Start + ((knots.End - knots.Start) * i / (count - 1));
    }

    [Fact]
    public void Points_have_what_either_way_is_expected_to_leave()
    {
        using var json = JsonDocument.Parse(CompensationDocument.Of(Report).Write());
        var point = json.RootElement.GetProperty("points")[3];
        Assert.Equal(1000 * Report.Result.Mirror.Errors[3], point.GetProperty("mirrorUm").GetDouble(), 6);
        Assert.Equal(1000 * Report.Result.ToolRadius.Errors[3], point.GetProperty("toolRadiusUm").GetDouble(), 6);
    }

    [Theory]
    [InlineData(0, "< 0.0001")]
    [InlineData(0.00009, "< 0.0001")]
    [InlineData(0.0321, "0.0321")]
    [InlineData(1, "1")]
    public void A_probability_is_never_said_to_be_none(double p, string said) => Assert.Equal(said, StructureTest.Words(p));

    // The chord of 20 um that the job allows is no small one.
    [Fact]
    public void Gouges_are_told_from_chords()
    {
        var page = Encoding.UTF8.GetString(CompensationReportHtml.Write(Report));
        Assert.DoesNotContain("p 0.", page, StringComparison.Ordinal);
        Assert.Contains("checked against the whole surface, nowhere does the ball cut deeper into it than", page, StringComparison.Ordinal);
        Assert.Equal(
            Report.ToolPath.Certificate.ChordMm > 0.01,
            page.Contains("None beyond the chord, by which a straight cut may lie up to", StringComparison.Ordinal));
    }

    [Fact]
    public void Cells_that_are_cut_away_are_outside_of_the_net()
    {
        var surface = Piece.Surface;
        var (u, v) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
        double middle = (u.Start + u.End) / 2;
        var net = SurfaceNet.Of(
            surface with { Region = new([[new(middle, v.Start), new(u.End, v.Start), new(u.End, v.End), new(middle, v.End)]]) });
        var cells = (net.CountU - 1) * (net.CountV - 1);
        Assert.Equal(Enumerable.Range(0, cells / 2), net.Outside);
    }

    [Fact]
    public void Page_is_well_formed_and_shows_maps_plots_and_points()
    {
        var page = Page(CompensationReportHtml.Write(Report));

        Assert.Equal("Surface <two> & co.: compensated surface", page.Descendants("h1").Single().Value);

        // Maps side by side, the uncertainty, two sections and either way by point.
        Assert.Equal(6, page.Descendants("svg").Count());
        Assert.Equal(70, page.Descendants("circle").Count(c => (string?)c.Attribute("class") == "key-point"));
        Assert.DoesNotContain(page.Descendants(), e => e.Name.LocalName is "script" or "img" or "link");
    }

    [Fact]
    public void A_page_for_a_shop_says_nothing_of_orders_it_has_not_and_of_other_systems()
    {
        var page = Page(CompensationReportHtml.Write(Report)).Descendants("body").Single().Value;
        Assert.DoesNotContain("work order", page, StringComparison.OrdinalIgnoreCase);
        Assert.DoesNotContain("paper", page, StringComparison.OrdinalIgnoreCase);
        Assert.DoesNotContain("CAD", page, StringComparison.Ordinal);
        var ordered = Page(CompensationReportHtml.Write(Report with { Job = Report.Job with { WorkOrder = "WO-7" } })).Root!.Value;
        Assert.Contains("Work order WO-7", ordered, StringComparison.Ordinal);
    }

    // Nothing can be left out of two lines: no number says what that would have cost.
    [Fact]
    public void Few_points_leave_figures_out_instead_of_writing_none_that_is_one()
    {
        var piece = new MeasuredDesign(PaperDesign.Two, "\"curves\": 7, \"pointsPerCurve\": 10", "\"curves\": 2, \"pointsPerCurve\": 2");
        var report = Report with { Result = piece.Compensate(piece.With((u, v) => 0.01 + (0.02 * u))).Result! };
        Assert.Equal(4, report.Result.Samples.Count);
        using var json = JsonDocument.Parse(CompensationDocument.Of(report).Write());
        Assert.Equal(JsonValueKind.Null, json.RootElement.GetProperty("compensation").GetProperty("leaveLineOutUm").ValueKind);
        Assert.DoesNotContain("NaN", Encoding.UTF8.GetString(CompensationReportHtml.Write(report)), StringComparison.Ordinal);
    }

    [Fact]
    public void Evaluation_has_what_scripts_read_and_people_look_at()
    {
        var report = new EvaluationReport(
            Report.Job,
            [],
            Piece.Surface,
            SurfaceEvaluation.Evaluate(Piece.Job, Piece.Surface, [Piece.Over(0, (u, v) => 0.001 * (u - v))]),
            SurfaceEvaluation.Evaluate(Piece.Job, Piece.Surface, [Piece.With((u, v) => 0.015 + (0.02 * u))]));
        using var json = JsonDocument.Parse(EvaluationReportJson.Write(report));

        Assert.Equal(70, json.RootElement.GetProperty("count").GetInt32());
        Assert.Equal(0, json.RootElement.GetProperty("meanUm").GetDouble(), 0);
        Assert.Equal(70, json.RootElement.GetProperty("before").GetProperty("profileIsoUm").GetDouble(), 6);
        Assert.Equal(20, json.RootElement.GetProperty("before").GetProperty("profileRangeUm").GetDouble(), 6);
        Assert.InRange(json.RootElement.GetProperty("improvement").GetProperty("standardDeviationPercent").GetDouble(), 80, 100);
        var page = Page(EvaluationReportHtml.Write(report));
        Assert.Equal(4, page.Descendants("svg").Count());
        Assert.Contains("better than before", page.Descendants("section").First().Value, StringComparison.Ordinal);
        Assert.StartsWith("Not judged", page.Descendants("strong").First().Value, StringComparison.Ordinal);
        Assert.False(json.RootElement.TryGetProperty("verdict", out _));
    }

    [Fact]
    public void Without_a_tolerance_the_first_line_judges_nothing_and_the_document_is_as_before()
    {
        var page = Page(CompensationReportHtml.Write(Report));
        var first = page.Descendants("header").Single().Elements().First();
        Assert.Equal(("verdict", "verdict"), ((string)first.Attribute("id")!, (string)first.Attribute("class")!));
        Assert.StartsWith("Not judged: the job states no profile tolerance", first.Value, StringComparison.Ordinal);
        using var json = JsonDocument.Parse(CompensationDocument.Of(Report).Write());
        Assert.False(json.RootElement.TryGetProperty("verdict", out _));
        Assert.DoesNotContain(page.Descendants("dt"), d => d.Value == "Tolerance");
    }

    // The error rises from 9 to 25 um along u; mirrored, nothing of it is left but the noise of no scatter.
    [Theory]
    [InlineData(0.0499, "outside")]
    [InlineData(0.0501, "within")]
    public void The_verdict_is_the_first_line_of_the_page_and_in_the_document(double width, string before)
    {
        var report = Judged(Report, new(width, DecisionRule.Simple, false));
        using var json = JsonDocument.Parse(CompensationDocument.Of(report).Write());
        var verdict = json.RootElement.GetProperty("verdict");
        Assert.True(verdict.GetProperty("inTolerance").GetBoolean());
        Assert.Equal("within", verdict.GetProperty("code").GetString());
        Assert.Equal(before, verdict.GetProperty("before").GetProperty("code").GetString());
        Assert.Equal(50, verdict.GetProperty("before").GetProperty("profileUm").GetDouble(), 6);
        Assert.Equal(1000 * width, verdict.GetProperty("toleranceUm").GetDouble(), 9);
        var first = Page(CompensationReportHtml.Write(report)).Descendants("header").Single().Elements().First();
        Assert.Equal("verdict holds", (string)first.Attribute("class")!);
        Assert.StartsWith("✓ Expected in tolerance", first.Value, StringComparison.Ordinal);
        Assert.Contains("Cut it.", first.Value, StringComparison.Ordinal);
        DocumentCheck.IsReadAndWritten(CompensationDocument.Of(report).Write(), StoredSurfaceTests.Again);

        // A program that stops with an alarm gets no check mark.
        first = Page(CompensationReportHtml.Write(report with { CallsTool = false })).Descendants("header").Single().Elements().First();
        Assert.Equal("verdict", (string)first.Attribute("class")!);
        Assert.DoesNotContain("Cut it.", first.Value, StringComparison.Ordinal);
    }

    [Fact]
    public void A_compensation_by_the_mean_that_leaves_too_much_is_not_to_be_cut()
    {
        // 16 um of tilt are left by the mean: 8 um to either side, where 7.5 are allowed.
        var report = Judged(Report, new(0.015, DecisionRule.Simple, false), isMirror: false);
        var verdict = report.Verdict!;
        Assert.Equal((ProfileCode.Outside, ProfileCode.Outside), (verdict.Before.Code, verdict.Predicted.Code));
        Assert.Equal(8, 1000 * Math.Abs(verdict.Predicted.WorstMm), 1);
        var first = Page(CompensationReportHtml.Write(report)).Descendants("header").Single().Elements().First();
        Assert.Equal("verdict fails", (string)first.Attribute("class")!);
        Assert.StartsWith("✗ Expected out of tolerance", first.Value, StringComparison.Ordinal);
    }

    // Errors of 15 to 35 um before; 1 um either way now, at the corners.
    [Theory]
    [InlineData(0.00199, false, "outside", "✗ Out of tolerance")]
    [InlineData(0.00201, true, "within", "✓ In tolerance")]
    public void Evaluated_pieces_are_judged_before_and_after(double width, bool isWithin, string code, string start)
    {
        var tolerance = new ProfileTolerance(width, DecisionRule.Simple, false);
        var job = Piece.Job with { Profile = tolerance };
        var report = new EvaluationReport(
            Report.Job,
            [],
            Piece.Surface,
            SurfaceEvaluation.Evaluate(job, Piece.Surface, [Piece.Over(0, (u, v) => 0.001 * (u - v))]),
            SurfaceEvaluation.Evaluate(job, Piece.Surface, [Piece.With((u, v) => 0.015 + (0.02 * u))]))
        {
            Tolerance = tolerance,
        };
        Assert.Equal(isWithin, report.IsInTolerance);
        using var json = JsonDocument.Parse(EvaluationReportJson.Write(report));
        var (verdict, root) = (json.RootElement.GetProperty("verdict"), json.RootElement);
        Assert.Equal(
            (code, isWithin, 1, isWithin ? 1 : 0),
            (
                verdict.GetProperty("code").GetString(),
                verdict.GetProperty("inTolerance").GetBoolean(),
                verdict.GetProperty("pieces").GetInt32(),
                verdict.GetProperty("piecesWithin").GetInt32()));
        Assert.Equal(2, root.GetProperty("pieces")[0].GetProperty("verdict").GetProperty("profileUm").GetDouble(), 6);
        Assert.Equal("outside", root.GetProperty("before").GetProperty("pieces")[0].GetProperty("verdict").GetProperty("code").GetString());
        var first = Page(EvaluationReportHtml.Write(report)).Descendants("header").Single().Elements().First();
        Assert.Equal(isWithin ? "verdict holds" : "verdict fails", (string)first.Attribute("class")!);
        Assert.StartsWith(start, first.Value, StringComparison.Ordinal);
        Assert.Contains("Before: out of tolerance, profile 70.00 µm.", first.Value, StringComparison.Ordinal);
    }

    // By the paper: what tool-radius modification leaves of the spread is what there was.
    [Fact]
    public void Pieces_compensated_by_tool_radius_stand_beside_the_mirrored_ones()
    {
        SurfaceEvaluation Of(int piece, Func<double, double, double> error) =>
            SurfaceEvaluation.Evaluate(Piece.Job, Piece.Surface, [piece == 0 ? Piece.Over(0, error) : Piece.With(error)]);
        var report = new EvaluationReport(
            Report.Job,
            [],
            Piece.Surface,
            Of(0, (u, v) => 0.001 * (u - v)),
            Of(1, (u, v) => 0.015 + (0.02 * u)),
            Of(0, (u, v) => 0.02 * (u - 0.5)),
            Of(1, (u, v) => 0.015 + (0.02 * u)));
        using var json = JsonDocument.Parse(EvaluationReportJson.Write(report));
        var radius = json.RootElement.GetProperty("toolRadius");

        // 2 max|d|: 20 of 70; max|d| is 0.01 at both ends.
        Assert.Equal(100 * (1 - (20 / 70.0)), radius.GetProperty("improvement").GetProperty("profileIsoPercent").GetDouble(), 4);
        Assert.Equal(0, radius.GetProperty("improvement").GetProperty("standardDeviationPercent").GetDouble(), 4);
        Assert.Equal(70, radius.GetProperty("before").GetProperty("profileIsoUm").GetDouble(), 6);
        var page = Page(EvaluationReportHtml.Write(report));

        // Maps side by side and errors by point for either way, and two sections.
        Assert.Equal(6, page.Descendants("svg").Count());
        Assert.Equal(4, page.Descendants("text").Count(t => t.Value == "x, mm"));
        Assert.Contains(
            "Compensated by tool radius instead: Standard deviation smaller by 0 %, profile smaller by 71 %.",
            page.Root!.Value,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Pieces_of_two_stages_are_no_replicas()
    {
        var evaluation = SurfaceEvaluation.Evaluate(
            Piece.Job, Piece.Surface, [Piece.With((u, v) => 0.015 + (0.02 * u)), Piece.Over(0, (u, v) => 0.001 * (u - v))]);
        Assert.Empty(evaluation.Pieces[0].Warnings);
        Assert.Equal("stages-differ", Assert.Single(evaluation.Pieces[1].Warnings).Code);
    }

    private static CompensationReport Judged(CompensationReport report, ProfileTolerance tolerance, bool isMirror = true)
    {
        var input = report.Result.Input;
        var job = input.Job with { Profile = tolerance, Compensation = input.Job.Compensation with { Mirror = isMirror } };
        return report with { Result = report.Result with { Input = input with { Job = job } } };
    }

    internal static XDocument Page(byte[] html) =>
        XDocument.Parse(Encoding.UTF8.GetString(html).Replace("<!DOCTYPE html>", "", StringComparison.Ordinal));

    private static CompensationReport Make(string name)
    {
        var result = Piece.Compensate(Piece.With((u, v) => 0.009 + (0.016 * u))).Result!;
        var dialect = NcDialects.Named("siemens-840d");
        var path = ToolPathPlanner.Plan(result.Surface, Piece.Job.Tool, Piece.Job.Toolpath, 0, dialect).Path!;
        return new(
            new(name, null, "job.json", new string('0', 64)),
            [new("measured", "m.csv", new string('1', 64))],
            result,
            path,
            new("finishing", "out/finishing.nc", new string('2', 64)),
            0.1);
    }
}
