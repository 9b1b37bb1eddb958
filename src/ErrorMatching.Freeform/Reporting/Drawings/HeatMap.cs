using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>A top view of the errors of a surface: colors for the field, a number at each measured point.</summary>
internal sealed class HeatMap
{
    private const double Width = 820, Left = 20, Right = 690, Top = 46, LegendLeft = 716, LegendWidth = 22;
    private const int CellsU = 48, CellsV = 40;

    // More numbers would cover the colors. They are then replaced by dots and listed in the table only.
    private const int MostLabels = 120;

    private readonly PartSurface _surface;
    private readonly double _minX, _maxY, _scale, _height, _limitUm;
    private readonly bool _hasNoSign;

    // The formatted corners of the cells. Each belongs to four cells of every map.
    private readonly string[] _corners;

    /// <summary>A map of a surface.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="limitUm">Absolute value in micrometers at the ends of the color scale, shared by maps that are compared.</param>
    public HeatMap(PartSurface surface, double limitUm)
    {
        (_surface, _limitUm) = (surface, Rounded(limitUm));
        var (minX, maxX, minY, maxY) = (double.MaxValue, double.MinValue, double.MaxValue, double.MinValue);
        var corners = new Point3[(CellsU + 1) * (CellsV + 1)];
        for (var i = 0; i <= CellsU; i++)
        {
            for (var j = 0; j <= CellsV; j++)
            {
                var p = corners[CornerNumber(i, j)] = _surface.Spline.PointAt(U(i), V(j));
                (minX, maxX, minY, maxY) = (Math.Min(minX, p.X), Math.Max(maxX, p.X), Math.Min(minY, p.Y), Math.Max(maxY, p.Y));
            }
        }

        _scale = (Right - Left) / Math.Max(maxX - minX, 1e-9);
        (_minX, _maxY) = (minX, maxY);
        _height = Math.Clamp((maxY - minY) * _scale, 60, 1200);
        _corners = Array.ConvertAll(corners, p => SvgNumber.Points([Place(p)]));
    }

    /// <summary>A map of the same surface for nonnegative values, such as an uncertainty: with half of the colors, and numbers without a
    /// sign.</summary>
    /// <param name="like">The map with the surface.</param>
    /// <param name="limitUm">Value in micrometers at the end of the color scale.</param>
    public HeatMap(HeatMap like, double limitUm)
    {
        (_surface, _limitUm, _hasNoSign) = (like._surface, Rounded(limitUm), true);
        (_minX, _maxY, _scale, _height, _corners) = (like._minX, like._maxY, like._scale, like._height, like._corners);
    }

    /// <summary>Writes the map.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    /// <param name="title">Title of the map.</param>
    /// <param name="fieldUm">Value in micrometers at (u, v); null if only points are known.</param>
    /// <param name="points">Points, each with a value in micrometers.</param>
    public void Write(HtmlText html, string id, string title, Func<double, double, double>? fieldUm, IReadOnlyList<PlottedPoint> points)
    {
        var height = Top + _height + 40;
        using (SvgShapes.Drawing(html, id, "plot", (Width, height), title, Describe(points)))
        {
            SvgShapes.Text(html, "drawing-title", Left, 18, "start", title + ", µm");
            if (fieldUm is not null)
            {
                WriteCells(html, fieldUm);
            }

            WritePoints(html, points);
            WriteLegend(html);
            SvgShapes.Text(
                html,
                "axis-label",
                Left,
                Top + _height + 24,
                "start",
                "Seen against z: x to the right, y up; u rises along the curves of the measuring plan.");
        }
    }

    private void WriteCells(HtmlText html, Func<double, double, double> fieldUm)
    {
        var cells = new List<string>[DivergingColors.Count];
        for (var i = 0; i < CellsU; i++)
        {
            for (var j = 0; j < CellsV; j++)
            {
                var (u, v) = (U(i + 0.5), V(j + 0.5));
                if (!_surface.Region.Contains(u, v))
                {
                    continue;
                }

                var color = DivergingColors.IndexOf(fieldUm(u, v), _limitUm);
                (cells[color] ??= []).Add($"M{Corner(i, j)}L{Corner(i + 1, j)} {Corner(i + 1, j + 1)} {Corner(i, j + 1)}Z");
            }
        }

        for (var color = 0; color < cells.Length; color++)
        {
            if (cells[color] is { } list)
            {
                var path = string.Concat(list);
                // The stroke closes the hairlines between neighbors in browsers.
                html.Empty(
                    "path",
                    ("d", path),
                    ("fill", DivergingColors.Hex(color)),
                    ("stroke", DivergingColors.Hex(color)),
                    ("stroke-width", "0.6"));
            }
        }
    }

    private void WritePoints(HtmlText html, IReadOnlyList<PlottedPoint> points)
    {
        foreach (var (label, at, value) in points)
        {
            var (x, y) = Place(at);
            SvgShapes.Circle(html, "key-point", x, y, 3, $"Point {label}: {Micrometres.Signed(value)} µm");
            if (points.Count <= MostLabels)
            {
                var anchor = x < Left + 20 ? "start" : x > Right - 20 ? "end" : "middle";
                SvgShapes.Text(html, "tick", x, y - 6, anchor, Micrometres.Signed(value));
            }
        }
    }

    private void WriteLegend(HtmlText html)
    {
        var first = _hasNoSign ? DivergingColors.IndexOf(0, _limitUm) : 0;
        var step = _height / (DivergingColors.Count - first);
        for (var i = first; i < DivergingColors.Count; i++)
        {
            html.Empty(
                "rect",
                ("x", SvgNumber.Of(LegendLeft)),
                ("y", SvgNumber.Of(Top + _height - ((i - first + 1) * step))),
                ("width", SvgNumber.Of(LegendWidth)),
                ("height", SvgNumber.Of(step)),
                ("fill", DivergingColors.Hex(i)));
        }

        for (var k = _hasNoSign ? 0 : -2; k <= 2; k++)
        {
            var value = _limitUm * k / 2;
            var y = Top + _height - ((DivergingColors.IndexOf(value, _limitUm) - first + 0.5) * step);
            SvgShapes.Text(
                html,
                "tick",
                LegendLeft + LegendWidth + 6,
                y + 4,
                "start",
                _hasNoSign ? Micrometres.Plain(value) : Micrometres.Signed(value));
        }
    }

    private static string Describe(IReadOnlyList<PlottedPoint> points)
    {
        if (points.Count == 0)
        {
            return "No measured points.";
        }

        var (low, high) = (points.MinBy(p => p.ValueUm)!, points.MaxBy(p => p.ValueUm)!);
        return $"Lowest {Micrometres.Signed(low.ValueUm)} µm at point {low.Label}, highest {Micrometres.Signed(high.ValueUm)} µm at point "
            + $"{high.Label}.";
    }

    // A round limit slightly above the largest value: a tenth of it is 1, 2 or 5 times a power of ten.
    private static double Rounded(double limitUm)
    {
        var limit = Math.Max(limitUm, 0.1);
        var step = RoundNumber.AtLeast(limit / 10);
        return Math.Ceiling(limit / step) * step;
    }

    private double U(double cell) =>
        _surface.Spline.KnotsU.Start + ((_surface.Spline.KnotsU.End - _surface.Spline.KnotsU.Start) * cell / CellsU);

    private double V(double cell) =>
        _surface.Spline.KnotsV.Start + ((_surface.Spline.KnotsV.End - _surface.Spline.KnotsV.Start) * cell / CellsV);

    private string Corner(int i, int j) => _corners[CornerNumber(i, j)];

    private static int CornerNumber(int i, int j) => (i * (CellsV + 1)) + j;

    private (double X, double Y) Place(Point3 p) => (Left + ((p.X - _minX) * _scale), Top + ((_maxY - p.Y) * _scale));
}
