using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Draws maps of a surface side by side at one color scale, seen against z, with axes in millimeters.</summary>
internal sealed class SurfaceMaps
{
    private const double Width = 1000, Left = 62, Top = 40, Below = 46, Between = 34, Legend = 110, LegendWidth = 20;
    private const double TallestMap = 560, CharacterWidth = 6.2, LabelHeight = 13, Gap = 3;
    private const int CellsU = 48, CellsV = 40;

    // More numbers would cover the colors, however small the maps' points are.
    private const int MostLabels = 120;

    private readonly PartSurface _surface;
    private readonly SurfaceOutline _outline;
    private readonly Lazy<SurfaceNet> _net;

    public SurfaceMaps(PartSurface surface)
    {
        (_surface, _outline) = (surface, new(surface));
        _net = new(() => SurfaceNet.Of(surface, CellsU, CellsV));
    }

    /// <summary>A map of a field that is known everywhere.</summary>
    /// <param name="title">Its title.</param>
    /// <param name="fieldUm">The value in micrometers at (u, v).</param>
    /// <param name="points">Measured points.</param>
    public MapPanel Panel(string title, Func<double, double, double> fieldUm, IReadOnlyList<PlottedPoint> points) => new(
        title, _net.Value, [.. SurfaceNet.Parameters(_surface, CellsU, CellsV).Select(p => fieldUm(p.U, p.V))], points);

    /// <summary>Writes a figure.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    /// <param name="scale">The colors of all maps.</param>
    /// <param name="panels">The maps from left to right, at least one.</param>
    public void Write(HtmlText html, string id, ColorScale scale, IReadOnlyList<MapPanel> panels)
    {
        var room = ((Width - Left - Legend - (Between * (Math.Max(2, panels.Count) - 1))) / Math.Max(2, panels.Count)) - 4;
        var perMm = Math.Min(
            room / Math.Max(_outline.MaxX - _outline.MinX, 1e-9), TallestMap / Math.Max(_outline.MaxY - _outline.MinY, 1e-9));
        var (width, height) = (perMm * (_outline.MaxX - _outline.MinX), Math.Max(perMm * (_outline.MaxY - _outline.MinY), 24));
        using (SvgShapes.Drawing(
            html, id, "plot", (Width, Top + height + Below), string.Join(" | ", panels.Select(p => p.Title)), Describe(panels)))
        {
            for (var k = 0; k < panels.Count; k++)
            {
                var frame = new MapFrame(_outline, perMm, Left + (k * (width + Between)), Top, width, height);
                SvgShapes.Text(html, "drawing-title", frame.Left, 18, "start", panels[k].Title + ", µm");
                WriteBands(html, $"{id}-c{ReportNumber.Count(k)}", frame, scale, panels[k]);
                frame.WriteAxes(html, hasNumbersOfY: k == 0);
                WritePoints(html, frame, panels[k].Points);
            }

            WriteLegend(html, scale, Left + (panels.Count * (width + Between)), height);
        }
    }

    private void WriteBands(HtmlText html, string clip, MapFrame frame, ColorScale scale, MapPanel panel)
    {
        if (!_outline.IsWhole)
        {
            using (html.In("clipPath", ("id", clip)))
            {
                html.Empty("path", ("d", frame.Outline), ("clip-rule", "evenodd"));
            }
        }

        var rings = new ContourRings(
            panel.Net.CountU, panel.Net.CountV, [.. panel.Net.Places.Select(p => frame.Place(p.X, p.Y))], panel.ValuesUm);
        using (html.In("g", ("clip-path", _outline.IsWhole ? null : $"url(#{clip})")))
        {
            // Each band is painted over the lower ones, so that no gap shows between two; those below the lowest value would not show.
            var (first, least) = (scale.First, panel.ValuesUm.Min());
            while (first < scale.Last && scale.LowerEnd(first + 1) <= least)
            {
                first++;
            }

            for (var band = first; band <= scale.Last; band++)
            {
                var data = rings.Above(band == first ? double.NegativeInfinity : scale.LowerEnd(band));
                if (data.Length > 0)
                {
                    WriteColor(html, "path", scale.ColorOf(band), ("d", data), ("fill-rule", "evenodd"));
                }
            }
        }
    }

    // The class is for a dark page, where the pale color in the middle would be a white block.
    private static void WriteColor(HtmlText html, string element, int color, params ReadOnlySpan<(string Name, string? Value)> shape) =>
        html.Empty(
            element, [("class", "h" + ReportNumber.Count(color)), ("fill", ColorScale.Hex(color)), .. shape]);

    private static void WritePoints(HtmlText html, MapFrame frame, IReadOnlyList<PlottedPoint> points)
    {
        foreach (var (label, at, value) in points)
        {
            var (x, y) = frame.Place(at.X, at.Y);
            SvgShapes.Circle(html, "key-point", x, y, 2.5, $"Point {label}: {Micrometres.Signed(value)} µm");
        }

        // The largest errors first: where two numbers would touch, the larger one is written.
        var written = new List<(double X, double Y, double Half)>();
        foreach (var (_, at, value) in points.OrderByDescending(p => Math.Abs(p.ValueUm)).Take(MostLabels))
        {
            var (x, y) = frame.Place(at.X, at.Y);
            var text = Micrometres.Signed(value);
            var half = text.Length * CharacterWidth / 2;
            var middle = Math.Clamp(x, frame.Left + half, Math.Max(frame.Left + half, frame.Left + frame.Width - half));
            var line = y - 6 < frame.Top + LabelHeight ? y + LabelHeight + 2 : y - 6;
            if (!written.Any(w => Math.Abs(w.X - middle) < w.Half + half + Gap && Math.Abs(w.Y - line) < LabelHeight))
            {
                written.Add((middle, line, half));
                SvgShapes.Text(html, "value", middle, line, "middle", text);
            }
        }
    }

    private static void WriteLegend(HtmlText html, ColorScale scale, double left, double height)
    {
        var bands = scale.Last - scale.First + 1;
        var step = height / bands;
        var every = (int)Math.Ceiling(LabelHeight / step);
        SvgShapes.Text(html, "axis-label", left, 18, "start", "µm");
        for (var band = scale.First; band <= scale.Last; band++)
        {
            var y = Top + height - ((band - scale.First + 1) * step);
            WriteColor(
                html,
                "rect",
                scale.ColorOf(band),
                ("x", SvgNumber.Of(left)),
                ("y", SvgNumber.Of(y)),
                ("width", SvgNumber.Of(LegendWidth)),
                ("height", SvgNumber.Of(step)));
            if (band % Every(every) == 0)
            {
                SvgShapes.Text(html, "tick", left + LegendWidth + 6, y + (step / 2) + 4, "start", scale.Label(band));
            }
        }
    }

    // Round numbers of bands between two labels.
    private static int Every(int least) => (int)RoundNumber.AtLeast(least);

    private static string Describe(IReadOnlyList<MapPanel> panels) => string.Join(" ", panels.Select(panel =>
    {
        var shown = $"{panel.Title}: from {Micrometres.Signed(panel.Shown.DefaultIfEmpty().Min())} to "
            + $"{Micrometres.Signed(panel.Shown.DefaultIfEmpty().Max())} µm.";
        if (panel.Points.Count == 0)
        {
            return shown;
        }

        var (low, high) = (panel.Points.MinBy(p => p.ValueUm)!, panel.Points.MaxBy(p => p.ValueUm)!);
        return $"{shown} Lowest point {low.Label} with {Micrometres.Signed(low.ValueUm)} µm, highest point {high.Label} with "
            + $"{Micrometres.Signed(high.ValueUm)} µm.";
    }));
}
