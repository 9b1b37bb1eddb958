using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The place of a map in a drawing, in pixels, with its axes in millimeters.</summary>
/// <param name="outline">The edges of the piece.</param>
/// <param name="perMm">Pixels per millimeter.</param>
/// <param name="left">Left end.</param>
/// <param name="top">Upper end.</param>
/// <param name="width">Width.</param>
/// <param name="height">Height.</param>
internal sealed class MapFrame(SurfaceOutline outline, double perMm, double left, double top, double width, double height)
{
    private const double Tick = 5;

    // About this many pixels between two ticks, so that numbers do not touch.
    private const double TickRoom = 56;

    /// <summary>Left end.</summary>
    public double Left => left;

    /// <summary>Upper end.</summary>
    public double Top => top;

    /// <summary>Width.</summary>
    public double Width => width;

    /// <summary>The edges of the piece, as the data of a path.</summary>
    public string Outline => string.Concat(outline.Loops.Select(
        l => $"M{string.Join('L', l.Select(p => SvgNumber.Points([Place(p.X, p.Y)])))}Z"));

    /// <summary>The pixel of a place in millimeters.</summary>
    public (double X, double Y) Place(double x, double y) =>
        (left + ((x - outline.MinX) * perMm), top + ((outline.MaxY - y) * perMm));

    /// <summary>Writes the edges of the piece and the axes.</summary>
    /// <param name="html">The output.</param>
    /// <param name="hasNumbersOfY">False if a map to the left has them.</param>
    public void WriteAxes(HtmlText html, bool hasNumbersOfY)
    {
        html.Empty("path", ("class", "map-edge"), ("d", Outline));
        var bottom = top + height;
        SvgShapes.Line(html, "map-edge", left, bottom, left + width, bottom);
        SvgShapes.Line(html, "map-edge", left, top, left, bottom);
        foreach (var x in RoundTicks.Within(outline.MinX, outline.MaxX, Math.Max(1, (int)(width / TickRoom))))
        {
            var at = Place(x, 0).X;
            SvgShapes.Line(html, "map-edge", at, bottom, at, bottom + Tick);
            SvgShapes.Text(html, "tick", at, bottom + Tick + 13, "middle", ReportNumber.Short(x));
        }

        SvgShapes.Text(html, "axis-label", left + (width / 2), bottom + 38, "middle", "x, mm");
        foreach (var y in RoundTicks.Within(outline.MinY, outline.MaxY, Math.Max(1, (int)(height / TickRoom))))
        {
            var at = Place(0, y).Y;
            SvgShapes.Line(html, "map-edge", left - Tick, at, left, at);
            if (hasNumbersOfY)
            {
                SvgShapes.Text(html, "tick", left - Tick - 3, at + 4, "end", ReportNumber.Short(y));
            }
        }

        if (hasNumbersOfY)
        {
            using (html.In(
                "text",
                ("class", "axis-label"),
                ("text-anchor", "middle"),
                ("transform", $"translate(14 {SvgNumber.Of(top + (height / 2))}) rotate(-90)")))
            {
                html.Text("y, mm");
            }
        }
    }
}
