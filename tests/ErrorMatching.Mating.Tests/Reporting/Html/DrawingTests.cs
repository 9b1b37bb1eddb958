using System.Xml.Linq;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating.Tests;

public sealed class DrawingTests
{
    [Theory]
    [InlineData(0.7, 1, 0.5)]
    [InlineData(1, 1, 1)]
    [InlineData(2.1, 5, 2)]
    [InlineData(60, 100, 50)]
    [InlineData(0.0013, 0.002, 0.001)]
    [InlineData(0.05, 0.05, 0.05)]
    public void Round_numbers_are_1_2_and_5_times_powers_of_ten(double value, double above, double below)
    {
        Assert.Equal(above, RoundNumber.AtLeast(value));
        Assert.Equal(below, RoundNumber.AtMost(value));
    }

    [Fact]
    public void Plot_puts_points_limits_and_zero_where_a_ruler_would()
    {
        ToleranceBand band = new(-0.05, 0.05);
        var svg = Draw(
            h => new ErrorPlot([new("a", "F", 0.04, 0, band), new("b", "F", -0.04, 0.01, band)]).Write(h, "p", "before", "after"));

        // Ticks of 0.02 from -0.06 to 0.06 over 300 - 52 pixels, zero at 176; two points over 716 - 74 pixels.
        Assert.Equal(
            ["-0.060", "-0.040", "-0.020", "0.000", "+0.020", "+0.040", "+0.060"],
            svg.WithClass("text", "tick").Select(t => t.Value).Take(7));
        Assert.Equal("234.5,93.33 555.5,258.67", Points(svg, "before"));
        Assert.Equal("234.5,176 555.5,155.33", Points(svg, "after"));
        Assert.Equal("176|176", Attributes(svg.WithClass("line", "zero").Single(), "y1", "y2"));
        Assert.Equal("74|72.67|642|206.67", Attributes(svg.WithClass("rect", "band").Single(), "x", "y", "width", "height"));
        Assert.Equal(["72.67", "279.33"], svg.WithClass("line", "limit").Select(l => Attributes(l, "y1")));
        Assert.Equal("before: largest error +0.040 mm at point a. after: largest error +0.010 mm at point b.", svg.Element("desc")!.Value);
    }

    [Fact]
    public void Plot_shows_what_is_left_with_its_interval_and_the_worst_place_between_the_points()
    {
        ToleranceBand band = new(-0.05, 0.05);
        var svg = Draw(h => new ErrorPlot(
            [
                new("a", "F", 0.04, 0.01, band) { Interval95Mm = 0.02 }, new("b", "F", -0.04, 0.01, band) { Interval95Mm = 0.02 },
                new("c", "G", -0.04, 0.01, band)],
            [new("F", 0.25, 0.03, 0.01, "X1 Y2"), new("G", 2, -0.02, 0.01, "X3 Y4")]).Write(h, "p", "before", "after"));

        // Three points over 642 pixels, 0.02 over 41.33 pixels, zero at 176.
        var intervals = svg.WithClass("path", "interval").Where(p => !p.HasClass("between")).Select(p => Attributes(p, "d")).ToArray();
        Assert.Equal(["M181,114L181,196.67", "M395,114L395,196.67"], intervals.Take(2).Select(d => d[..d.IndexOf('M', 1)]));
        var marker = svg.WithClass("path", "between").First(p => p.HasClass("marker"));
        Assert.StartsWith("M229.5,114L239.5,114", (string?)marker.Attribute("d"), StringComparison.Ordinal);
        Assert.Equal("Between the points: +0.0300 ± 0.0100 mm on F near X1 Y2", marker.Value);
        Assert.Equal("234.5|114", Attributes(svg.WithClass("circle", "ring").Single(), "cx", "cy"));
        Assert.Contains("Point a, after: +0.0100 ± 0.0200 mm", svg.Descendants("title").Select(t => t.Value));
        Assert.EndsWith(
            "Between the points: largest error +0.0300 ± 0.0100 mm on F near X1 Y2.", svg.Element("desc")!.Value, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("")]
    [InlineData("PT")]
    [InlineData("a-long-label")]
    public void Labels_of_60_points_do_not_touch(string prefix)
    {
        var svg = Draw(h => new ErrorPlot([.. Enumerable.Range(1, 60).Select(i => new PlotPoint($"{prefix}{i}", "F", 0, 0, null))]).Write(
            h, "p", "before", "after"));

        var labels = svg.WithClass("text", "tick").Where(t => (string?)t.Attribute("y") == "318").ToArray();
        Assert.True(labels.Length >= 12);
        Assert.All(
            labels.Zip(labels.Skip(1)),
            l => Assert.True(X(l.Second) - X(l.First) >= (7 * Math.Max(l.First.Value.Length, l.Second.Value.Length)) + 4));

        static double X(XElement label) => (double)label.Attribute("x")!;
    }

    [Fact]
    public void Plot_shows_zero_even_where_all_errors_are_on_one_side()
    {
        var axis = PlotAxis.Around([0.3, 0.5]);

        Assert.Equal((0.1, -1, 6), (axis.Step, axis.First, axis.Last));
        Assert.Equal((0.002, -3, 3), (PlotAxis.Around([]).Step, PlotAxis.Around([]).First, PlotAxis.Around([]).Last));
    }

    [Fact]
    public void Limits_that_change_are_labelled_where_they_change()
    {
        var svg = Draw(
            h => new ErrorPlot(
                [new("a", "F", 0, 0, new(-0.05, 0.05)), new("b", "G", 0, 0, new(-0.02, 0.01)), new("c", "H", 0, 0, null)])
                .Write(h, "p", "b", "a"));

        Assert.Equal(
            ["limit +0.050", "limit -0.050", "limit +0.010", "limit -0.020"], svg.WithClass("text", "limit-label").Select(t => t.Value));
        Assert.Equal(["74|214", "288|214"], svg.WithClass("rect", "band").Select(r => Attributes(r, "x", "width")));
    }

    [Fact]
    public void Assembly_shows_the_part_and_the_counterpart_apart_by_the_exaggerated_gap()
    {
        // The part lies 0.1 mm beyond a horizontal boundary of 100 mm, the counterpart on it:
        // 50 times exaggerated the gap is 5 mm, at 4.2 pixels a millimetre 21 pixels.
        var scene = Scene(
            new DrawnPoint("1", new(0, 0), new(0, 1), 0.1, 0, 0.1), new DrawnPoint("2", new(100, 0), new(0, 1), 0.1, 0, 0.1))!;
        var before = Draw(h => new AssemblyDrawing(scene, p => p.Before).Write(h, "b", "before"));
        var after = Draw(h => new AssemblyDrawing(scene, p => p.After).Write(h, "a", "after"));

        Assert.Equal((50, 4.2), (scene.Factor, scene.PixelsPerMm));
        Assert.Equal("56,64 476,64", Points(before, "part"));
        Assert.Equal("56,85 476,85", Points(before, "counterpart"));
        Assert.Equal(Points(after, "part"), Points(after, "counterpart"));
        Assert.EndsWith(
            "The largest mating error is -0.100 mm at point 1: a gap.", before.Element("desc")!.Value, StringComparison.Ordinal);
        Assert.Contains("0.1 mm of deviation", before.WithClass("text", "legend").Select(t => t.Value));

        // The part's material lies beyond its outline, the counterpart's behind its own.
        Assert.Equal("56,64 476,64 476,51 56,51", (string?)before.WithClass("polygon", "part").Single().Attribute("points"));
        Assert.Equal("56,85 476,85 476,98 56,98", (string?)before.WithClass("polygon", "counterpart").Single().Attribute("points"));
    }

    [Fact]
    public void Material_is_on_the_side_that_the_normals_say_whatever_the_direction_of_cutting()
    {
        DrawnPoint[] points = [new("1", new(0, 0), new(0, -1), 0.1, 0, 0), new("2", new(100, 0), new(0, -1), 0.1, 0, 0)];

        Assert.All(
            DrawnFeature.Of([new(0, 0), new(100, 0)], points) is { } f ? Enumerable.Range(0, f.Segments).Select(f.Normal) : [],
            n => Assert.Equal(new(0, -1), n));
        Assert.All(
            DrawnFeature.Of([new(100, 0), new(0, 0)], points) is { } g ? Enumerable.Range(0, g.Segments).Select(g.Normal) : [],
            n => Assert.Equal(new(0, -1), n));
    }

    [Fact]
    public void Displaced_pieces_meet_in_the_intersection_of_their_lines()
    {
        // Up to (0,10), then right: displaced by 1 to the left and by 2 upward they meet in (-1,12).
        var first = DrawnFeature.Of(
            [new(0, 0), new(0, 10)], [new("1", new(0, 0), new(-1, 0), 1, 0, 0), new("2", new(0, 10), new(-1, 0), 1, 0, 0)])!;
        var second = DrawnFeature.Of(
            [new(0, 10), new(10, 10)], [new("3", new(0, 10), new(0, 1), 2, 0, 0), new("4", new(10, 10), new(0, 1), 2, 0, 0)])!;

        var line = Assert.Single(DisplacedBoundary.Of(DisplacedBoundary.Chains([first, second], 0.1), (f, v) => f.At(v, p => p.Part)));

        Assert.Equal([new(-1, 0), new(-1, 12), new(10, 12)], line);
        Assert.Equal(2, DisplacedBoundary.Chains([second, first], 0.1).Count);
    }

    [Fact]
    public void Displaced_pieces_meet_at_oblique_angles_too()
    {
        // Up to (0,10), then along (4,3): v with v . (-1,0) = 1 and v . (-0.6,0.8) = 2 is (-1,1.75).
        var first = DrawnFeature.Of(
            [new(0, 0), new(0, 10)], [new("1", new(0, 0), new(-1, 0), 1, 0, 0), new("2", new(0, 10), new(-1, 0), 1, 0, 0)])!;
        var second = DrawnFeature.Of(
            [new(0, 10), new(4, 13)], [new("3", new(0, 10), new(-0.6, 0.8), 2, 0, 0), new("4", new(4, 13), new(-0.6, 0.8), 2, 0, 0)])!;

        var line = Assert.Single(DisplacedBoundary.Of(DisplacedBoundary.Chains([first, second], 0.1), (f, v) => f.At(v, p => p.Part)));

        Assert.Equal((-1, 11.75), (Math.Round(line[1].X, 12), Math.Round(line[1].Y, 12)));
    }

    [Fact]
    public void Deviations_change_evenly_between_key_points_and_stay_beyond_them()
    {
        var feature = DrawnFeature.Of(
            [new(0, 0), new(5, 0), new(10, 0)], [new("2", new(8, 0), new(0, 1), 4, 0, 0), new("1", new(2, 0), new(0, 1), 1, 0, 0)])!;

        // Vertices at 0, 2 (key point), 5, 8 (key point), 10.
        Assert.Equal([1, 1, 2.5, 4, 4], Enumerable.Range(0, feature.Segments + 1).Select(v => feature.At(v, p => p.Part)));
    }

    [Fact]
    public void The_step_back_of_an_offset_path_is_smoothed_away()
    {
        var outline = DrawnOutline.Of([new(0, 0), new(50, 0), new(49.9, 0.01), new(100, 1)])!;

        Assert.Equal(2, outline.Segments);
        Assert.Equal(49.95, outline.Vertex(1).X, 9);
        Assert.Null(DrawnOutline.Of([new(1, 1), new(1, 1)]));
    }

    [Fact]
    public void Without_deviations_the_assembly_is_drawn_true_to_scale()
    {
        var scene = Scene(new DrawnPoint("1", new(0, 0), new(0, 1), 0, 0, 0), new DrawnPoint("2", new(100, 0), new(0, 1), 0, 0, 0))!;

        Assert.Equal((1, "true to scale"), (scene.Factor, scene.FactorText));
        Assert.Null(Scene(new DrawnPoint("1", new(0, 0), new(0, 1), 0.1, 0, 0)));
    }

    // A square of side 10 from its corner, a deviation in the middle of its first side and of its last: the corner lies half way between
    // both, seen from either end.
    [Fact]
    public void A_closed_boundary_closes_in_its_drawing()
    {
        Point2[] square = [new(0, 0), new(10, 0), new(10, 10), new(0, 10), new(0, 0)];
        var feature = DrawnFeature.Of(square, [new("1", new(5, 0), new(0, -1), 1, 0, 0), new("2", new(0, 5), new(-1, 0), 3, 0, 0)])!;
        Assert.Equal((2, 2), (feature.At(0, p => p.Part), feature.At(feature.Segments, p => p.Part)));
    }

    private static AssemblyScene? Scene(params DrawnPoint[] points) => AssemblyScene.Of([DrawnFeature.Of([], points)]);

    private static XElement Draw(Action<HtmlText> draw)
    {
        var html = new HtmlText();
        draw(html);
        return PageReader.Read(html.ToBytes());
    }

    private static string? Points(XElement svg, string name) => (string?)svg.WithClass("polyline", name).Single().Attribute("points");

    private static string Attributes(XElement element, params string[] names) =>
        string.Join('|', names.Select(n => (string?)element.Attribute(n)));
}
