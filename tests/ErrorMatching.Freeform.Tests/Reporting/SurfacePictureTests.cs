using System.Globalization;
using System.Xml.Linq;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform.Tests;

/// <summary>What a shop sees in the pictures of a report.</summary>
public sealed class SurfacePictureTests
{
    [Fact]
    public void Measured_and_expected_are_side_by_side_at_one_scale_with_axes_in_millimeters()
    {
        // The error rises with u from 9 to 25 um, and nothing of it is left: bands of 2 um from zero to the strongest, nothing blue. That
        // of 9 um is a third of the way.
        var maps = SurfaceReportTests.Page(CompensationReportHtml.Write(SurfaceReportTests.Report)).Descendants("svg").First();
        var groups = maps.Elements("g").Select(g => g.Elements("path").Select(Color).ToArray()).ToArray();
        Assert.Equal(2, groups.Length);
        var legend = maps.Elements("rect").Select(Color).ToArray();
        Assert.InRange(legend.Length, 13, 14);
        Assert.Equal((20, 40), (legend[0], legend[^1]));
        Assert.Equal(legend.Order(), legend);
        Assert.InRange(groups[0][0], 26, 28);
        Assert.Equal(legend.Where(c => c >= groups[0][0]), groups[0]);
        Assert.Equal([20], groups[1]);
        var texts = maps.Elements("text").Select(t => t.Value).ToArray();
        Assert.Equal((2, 1), (texts.Count(t => t == "x, mm"), texts.Count(t => t == "y, mm")));
        Assert.Equal(
            ["0", "20", "40", "60", "0", "20", "40", "60"],
            texts.SkipWhile(t => t != "0").Where(t => t.All(char.IsAsciiDigit)).Take(8));

        static int Color(XElement e)
        {
            var color = int.Parse(((string)e.Attribute("class")!)[1..], CultureInfo.InvariantCulture);
            Assert.Equal(ColorScale.Hex(color), (string)e.Attribute("fill")!);
            return color;
        }
    }

    // Bands are painted over each other, without one square for each point and without gaps.
    [Fact]
    public void A_band_is_one_path_however_many_points_the_map_has()
    {
        var page = SurfaceReportTests.Page(CompensationReportHtml.Write(SurfaceReportTests.Report));
        var map = page.Descendants("svg").First().Elements("g").First();
        Assert.InRange(map.Elements("path").Count(), 8, 10);
        Assert.All(map.Elements("path"), p => Assert.Equal("evenodd", (string)p.Attribute("fill-rule")!));
    }

    [Fact]
    public void An_uncertainty_has_no_sign_and_the_colors_of_one_side()
    {
        var map = SurfaceReportTests.Page(CompensationReportHtml.Write(SurfaceReportTests.Report)).Descendants("svg").ElementAt(1);
        var colors = map.Descendants("rect").Select(r => (string)r.Attribute("fill")!).ToArray();
        Assert.Equal(ColorScale.Hex(20), colors[0]);
        Assert.Equal(ColorScale.Hex(40), colors[^1]);
        Assert.DoesNotContain(map.Descendants("text"), t => t.Value.StartsWith('+'));
    }

    [Fact]
    public void A_trimmed_piece_is_drawn_up_to_its_edges()
    {
        var (u, v) = (SurfaceReportTests.Piece.Surface.Spline.KnotsU, SurfaceReportTests.Piece.Surface.Spline.KnotsV);
        double middle = (u.Start + u.End) / 2;
        var trimmed = SurfaceReportTests.Piece.Surface with
        {
            Region = new([[new(u.Start, v.Start), new(middle, v.Start), new(middle, v.End), new(u.Start, v.End)]]),
        };
        var html = new HtmlText();
        var maps = new SurfaceMaps(trimmed);
        var panel = maps.Panel("half", (a, _) => 20 * a, []);
        using (html.In("body"))
        {
            maps.Write(html, "m", ColorScale.OfErrors(panel.Shown), [panel]);
        }

        // The error is 0 to 10 on the half that there is.
        Assert.InRange(panel.Shown.Max(), 9, 10.01);
        var svg = SurfaceReportTests.Page(html.ToBytes()).Descendants("svg").Single();
        Assert.Equal("url(#m-c0)", (string)svg.Element("g")!.Attribute("clip-path")!);
        Assert.Equal("m-c0", (string)svg.Element("clipPath")!.Attribute("id")!);
        Assert.Contains("half: from 0.0 to +", svg.Element("desc")!.Value, StringComparison.Ordinal);
    }

    // Figure 6 of the paper: the surface is cut as far on the other side of the ideal one as it was measured.
    [Fact]
    public void A_section_shows_what_was_measured_what_is_cut_and_what_is_expected()
    {
        var section = SurfaceReportTests.Page(CompensationReportHtml.Write(SurfaceReportTests.Report)).Descendants("svg").ElementAt(2);
        Assert.StartsWith("Along u through point ", section.Element("title")!.Value, StringComparison.Ordinal);
        Assert.Equal(
            "expected after: from 0.0 to 0.0 µm. as cut: moved to the other side: from -25.0 to -9.0 µm. measured: from +9.0 to +25.0 µm.",
            section.Element("desc")!.Value);
        Assert.Equal(10, section.Elements("circle").Count());
        Assert.Contains("Along the surface, mm", section.Elements("text").Select(t => t.Value));
    }

    // The second piece shows nearly nothing, because the first one's correction was cut into it: a map of that would hide what the program
    // corrects.
    [Fact]
    public void A_lot_is_drawn_as_the_piece_that_no_correction_would_leave()
    {
        var design = new MeasuredDesign(
            PaperDesign.Two, "\"measuredAfter\": \"semi-finishing\"", "\"measuredAfter\": \"finishing\"");
        var first = design.Compensate(design.With((u, v) => 0.009 + (0.016 * u))).Result!;
        var second = design.With((u, v) => 0.0005 + 0.009 + (0.016 * u) - first.Compensated.At(u, v), "second.csv");
        var result = Compensator.Compensate(new(design.Job, design.Surface, design.Plan, [second]) { Previous = first.Pieces }).Result!;
        var page = SurfaceReportTests.Page(CompensationReportHtml.Write(SurfaceReportTests.Report with { Result = result }));
        var maps = page.Descendants("svg").First();

        // A shape without a color of the page's is black, also on a dark page.
        Assert.Contains(page.Descendants("polygon"), d => (string?)d.Attribute("class") == "left marker");
        Assert.Contains(".left.marker { fill: var(--ink); }", page.Descendants("style").Single().Value, StringComparison.Ordinal);
        Assert.StartsWith("Without corrections | Expected", maps.Element("title")!.Value, StringComparison.Ordinal);
        var largest = maps.Elements("text").Where(t => (string?)t.Attribute("class") == "value").Select(t => t.Value).First();
        Assert.InRange(double.Parse(largest, CultureInfo.InvariantCulture), 24, 26);
        var section = page.Descendants("svg")
            .First(s => s.Element("title")!.Value.StartsWith("Along u", StringComparison.Ordinal));
        Assert.Contains("without corrections: from +9.", section.Element("desc")!.Value, StringComparison.Ordinal);
    }
}
