using System.Text;
using System.Text.Json;
using System.Xml.Linq;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform.Tests;

public sealed class SurfaceReportTests
{
    private static readonly MeasuredDesign Piece = new(PaperDesign.Two, "\"scallopMm\": 0.001, \"chordMm\": 0.001", "\"scallopMm\": 0.1, \"chordMm\": 0.02");
    private static readonly CompensationReport Report = Make("Surface <two> & co.");

    [Fact]
    public void Compensation_has_what_scripts_read()
    {
        using var json = JsonDocument.Parse(CompensationReportJson.Write(Report));
        var root = json.RootElement;

        Assert.Equal("errormatch/surface-compensate/1", root.GetProperty("schema").GetString());
        Assert.Equal(17, root.GetProperty("before").GetProperty("meanUm").GetDouble(), 0);
        Assert.Equal("systematic", root.GetProperty("structure").GetProperty("verdict").GetString());
        Assert.Equal(70, root.GetProperty("points").GetArrayLength());
        Assert.Equal(1000 * Report.Result.Samples[3].ErrorMm, root.GetProperty("points")[3].GetProperty("errorUm").GetDouble(), 6);
        Assert.InRange(root.GetProperty("toolpath").GetProperty("scallopUm").GetDouble(), 50, 100);
        Assert.True(root.GetProperty("predicted").GetProperty("toolRadius").GetProperty("standardDeviationUm").GetDouble() > root.GetProperty("predicted").GetProperty("mirror").GetProperty("standardDeviationUm").GetDouble());
    }

    [Fact]
    public void Page_is_well_formed_and_shows_maps_plots_and_points()
    {
        var page = Page(CompensationReportHtml.Write(Report));

        Assert.Equal("Surface <two> & co.: compensated surface", page.Descendants("h1").Single().Value);
        Assert.Equal(5, page.Descendants("svg").Count());
        Assert.Equal(70, page.Descendants("circle").Count(c => (string?)c.Attribute("class") == "key-point"));
        Assert.DoesNotContain(page.Descendants(), e => e.Name.LocalName is "script" or "img" or "link");
    }

    [Fact]
    public void Colors_of_the_map_are_those_of_the_error()
    {
        // The error rises with u from 9 to 25 um: the left end is paler than the right one, and nothing is blue.
        var map = Page(CompensationReportHtml.Write(Report)).Descendants("svg").First();
        var fills = map.Descendants("path").Select(p => (string)p.Attribute("fill")!).ToArray();

        Assert.All(fills, f => Assert.True(Array.IndexOf(Colors, f) >= DivergingColors.Count / 2, f));
        Assert.Contains(DivergingColors.Hex(DivergingColors.IndexOf(9, 30)), fills);
        Assert.Contains(DivergingColors.Hex(DivergingColors.IndexOf(25, 30)), fills);
    }

    [Fact]
    public void Evaluation_has_what_scripts_read_and_people_look_at()
    {
        var report = new EvaluationReport(
            Report.Job,
            [],
            Piece.Surface,
            SurfaceEvaluation.Of(Piece.Job, Piece.Surface, [Piece.Over(0, (u, v) => 0.001 * (u - v))]),
            SurfaceEvaluation.Of(Piece.Job, Piece.Surface, [Piece.With((u, v) => 0.015 + (0.02 * u))]));
        using var json = JsonDocument.Parse(EvaluationReportJson.Write(report));

        Assert.Equal(70, json.RootElement.GetProperty("count").GetInt32());
        Assert.Equal(0, json.RootElement.GetProperty("meanUm").GetDouble(), 0);
        Assert.Equal(70, json.RootElement.GetProperty("before").GetProperty("profileIsoUm").GetDouble(), 6);
        Assert.Equal(20, json.RootElement.GetProperty("before").GetProperty("profileRangeUm").GetDouble(), 6);
        Assert.InRange(json.RootElement.GetProperty("improvement").GetProperty("standardDeviationPercent").GetDouble(), 80, 100);
        var page = Page(EvaluationReportHtml.Write(report));
        Assert.Equal(3, page.Descendants("svg").Count());
        Assert.Contains("better than before", page.Descendants("strong").First().Value, StringComparison.Ordinal);
    }

    private static string[] Colors => [.. Enumerable.Range(0, DivergingColors.Count).Select(DivergingColors.Hex)];

    private static XDocument Page(byte[] html) => XDocument.Parse(Encoding.UTF8.GetString(html).Replace("<!DOCTYPE html>", "", StringComparison.Ordinal));

    private static CompensationReport Make(string name)
    {
        var result = Piece.Compensate(Piece.With((u, v) => 0.009 + (0.016 * u))).Result!;
        var dialect = NcDialects.Named("siemens-840d");
        var path = ToolPathPlanner.Plan(result.Surface, Piece.Job.Tool, Piece.Job.Toolpath, 0, dialect).Path!;
        return new(new(name, null, "job.json", new string('0', 64)), [new("measured", "m.csv", new string('1', 64))], result, path, new("finishing", "out/finishing.nc", new string('2', 64)), 0.1);
    }
}
