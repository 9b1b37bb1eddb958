using System.Text.Json;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The samples agree with themselves and with the paper, as the referee sees them.</summary>
public sealed class SampleTests
{
    private const double ToolRadius = 3;

    private static readonly JsonDocumentOptions Commented = new()
    {
        CommentHandling = JsonCommentHandling.Skip,
        AllowTrailingCommas = true
    };

    // Point 3 of the tooth belongs to no feature: it is the apex, which no probe reaches.
    [Theory]
    [InlineData("curve-mating")]
    [InlineData("complex-mating")]
    [InlineData("circle-mating")]
    [InlineData("slot-mating")]
    public void Key_points_lie_on_the_boundary_that_the_program_cuts(string sample)
    {
        var cut = new VirtualCut(SampleFile.Moves(sample, "counterpart.nc"), ToolRadius);

        Assert.All(
            SampleFile.Points(sample, "theoretical.csv").Where(p => p.Label != "3" || sample != "complex-mating"),
            p => Assert.InRange(cut.Clearance(p.Place), -0.001, 0.001));
    }

    // The material is at +x of the path: a probe that comes from the tool finds every key point of the curves.
    [Theory]
    [InlineData("curve-mating", "1")]
    [InlineData("complex-mating", "5")]
    public void Material_is_at_plus_x_of_the_curve(string sample, string first)
    {
        var cut = new VirtualCut(SampleFile.Moves(sample, "counterpart.nc"), ToolRadius);

        Assert.All(SampleFile.Points(sample, "theoretical.csv").SkipWhile(p => p.Label != first), p =>
            Assert.InRange(cut.Probe(p.Place, new(-1, 0)), -0.001, 0.001));
    }

    [Theory]
    [InlineData("curve-mating")]
    [InlineData("complex-mating")]
    [InlineData("circle-mating")]
    [InlineData("slot-mating")]
    [InlineData("dovetail")]
    public void Measured_files_name_the_points_of_the_theoretical_one_in_the_same_order(string sample)
    {
        var labels = SampleFile.Points(sample, "theoretical.csv").Select(p => p.Label);

        Assert.All(
            new[] { "part.csv", "counterpart.csv", "counterpart-after.csv" },
            f => Assert.Equal(labels, SampleFile.Points(sample, f).Select(p => p.Label)));
    }

    // The paper's uncompensated line ends in the rounded corner, which is why no limit is set for the counterparts.
    [Theory]
    [InlineData("curve-mating", 0.105)]
    [InlineData("complex-mating", 0.137)]
    public void Part_deviates_by_a_plausible_amount_from_the_boundary(string sample, double limit)
    {
        var cut = new VirtualCut(SampleFile.Moves(sample, "counterpart.nc"), ToolRadius);
        var points = SampleFile.Points(sample, "part.csv")
            .Where(p => p.Label != "3" || sample == "curve-mating")
            .Select(p => Math.Abs(cut.Clearance(p.Place)))
            .ToList();

        Assert.InRange(points.Max(), 0.05, limit);
    }

    [Fact]
    public void Published_points_stand_as_printed()
    {
        AssertColumns("curve-mating", "part.csv", PublishedTable.CurvePart, "");
        AssertColumns("curve-mating", "counterpart.csv", PublishedTable.CurveBefore, "measured_");
        AssertColumns("curve-mating", "counterpart-after.csv", PublishedTable.CurveAfter, "measured_", corrected: "7");
        AssertColumns("complex-mating", "part.csv", PublishedTable.ComplexPart, "");
        AssertColumns("complex-mating", "counterpart.csv", PublishedTable.ComplexBefore, "measured_");
        AssertColumns("complex-mating", "counterpart-after.csv", PublishedTable.ComplexAfter, "measured_");
    }

    [Theory]
    [InlineData("part.csv", 118.948, 63.948)]
    [InlineData("counterpart.csv", 119.542, 64.878)]
    [InlineData("counterpart-after.csv", 119.061, 63.83)]
    public void Flanks_enclose_the_printed_angles(string file, double lineToFlank, double included)
    {
        var at = SampleFile.Points("complex-mating", file).ToDictionary(p => p.Label, p => p.Place);
        var line = at["1"] - at["2"];
        var flank = at["3a"] - at["2a"];
        var back = at["4"] - at["3b"];

        Assert.InRange(Degrees(line, flank), lineToFlank - 0.001, lineToFlank + 0.001);
        Assert.InRange(Degrees(-flank, back), included - 0.001, included + 0.001);
    }

    [Fact]
    public void Tooth_is_tangent_and_about_one_center()
    {
        var moves = SampleFile.Moves("complex-mating", "counterpart.nc").ToDictionary(m => m.Block);
        var (into, first, second, back) = (moves["N130"], moves["N140"], moves["N150"], moves["N160"]);

        Assert.All([first, second], arc => Assert.InRange((arc.Center - new Flat(-42.334, 48.745)).Length, 0, 0.001));
        Assert.All([first, second], arc => Assert.InRange(arc.Radius, 5.999, 6.001));
        Assert.InRange(Degrees(Span(into), (first.From.In(WorkPlane.XY) - first.Center).Left), 0, 0.01);
        Assert.InRange(Degrees(Span(back), (second.To.In(WorkPlane.XY) - second.Center).Left), 0, 0.01);
    }

    [Fact]
    public void Complex_counterpart_goes_through_the_points_visible_in_figure_9()
    {
        var visible = SampleFile.Moves("figure-nine", "original.nc").Select(m => m.To.In(WorkPlane.XY));

        Assert.Subset(
            SampleFile.Moves("complex-mating", "counterpart.nc").Select(m => m.To.In(WorkPlane.XY)).ToHashSet(), visible.ToHashSet());
    }

    [Fact]
    public void Figure_nine_is_the_printed_text_with_one_block_added()
    {
        var original = SampleFile.Text("figure-nine", "original.nc");

        Assert.Equal(Published("figure9_original.nc"), original.Replace("N8970 X-45.275 Y53.975\n", "", StringComparison.Ordinal));
        Assert.Equal(Published("figure9_modified.nc"), SampleFile.Text("figure-nine", "modified.nc"));
        Assert.StartsWith("N8960 X-34.995 Y59.757 F1000.\nN8970 X-45.275 Y53.975\nN8980 G3 ", original, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("curve-mating")]
    [InlineData("complex-mating")]
    [InlineData("dovetail")]
    public void Job_selects_blocks_and_points_that_exist(string sample)
    {
        using var job = JsonDocument.Parse(SampleFile.Text(sample, "job.json"), Commented);
        var blocks = SampleFile.Moves(sample, "counterpart.nc").Select(m => m.Block).ToHashSet(StringComparer.Ordinal);
        var labels = SampleFile.Points(sample, "theoretical.csv").Select(p => p.Label).ToHashSet(StringComparer.Ordinal);

        foreach (var feature in job.RootElement.GetProperty("features").EnumerateArray())
        {
            Assert.All(Words(feature.GetProperty("blocks")).SelectMany(b => b.Split("..")), b => Assert.Contains(b, blocks));
            Assert.All(Words(feature.GetProperty("points")).SelectMany(p => p.Split("..")), p => Assert.Contains(p, labels));
        }
    }

    // The cutting data of table 1: 6 mm tool, 6000 rpm, 500 mm/min, 13.5 mm deep.
    [Theory]
    [InlineData("curve-mating")]
    [InlineData("complex-mating")]
    public void Program_cuts_with_the_data_of_table_1(string sample)
    {
        var text = SampleFile.Text(sample, "counterpart.nc");

        Assert.All(["D6", "S6000 ", "F500.", "Z-13.5", "M30", "G43 H1"], w => Assert.Contains(w, text, StringComparison.Ordinal));
    }

    private static IEnumerable<string> Words(JsonElement element) =>
        element.ValueKind == JsonValueKind.Array ? element.EnumerateArray().SelectMany(Words) : [element.GetString()!];

    private static Flat Span(RefereeMove move) => move.To.In(WorkPlane.XY) - move.From.In(WorkPlane.XY);

    private static double Degrees(Flat a, Flat b) => Math.Abs(Math.Atan2(a.Cross(b), a.Dot(b))) * 180 / Math.PI;

    private static string Published(string file) =>
        File.ReadAllText(Testing.Repository.PathTo("tests", "ErrorMatching.EndToEnd.Tests", "Data", "wang2021", file));

    private static void AssertColumns(string sample, string file, PublishedTable table, string prefix, string corrected = "")
    {
        var at = SampleFile.Points(sample, file).ToDictionary(p => p.Label, p => p.Place);
        foreach (var label in table.Points)
        {
            Assert.Equal((double)table.At(label, prefix + "x_mm") - (label == corrected ? 0.1 : 0), at[label].U, 12);
            Assert.Equal((double)table.At(label, prefix + "y_mm"), at[label].V, 12);
        }
    }
}
