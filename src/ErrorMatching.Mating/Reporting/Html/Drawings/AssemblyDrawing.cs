using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Part and counterpart in contact, with exaggerated deviations, like figures 14 and 19 of Wang 2021.</summary>
/// <param name="scene">The scene to draw.</param>
/// <param name="counterpart">The counterpart's deviation at a point.</param>
internal sealed class AssemblyDrawing(AssemblyScene scene, Func<DrawnPoint, double> counterpart)
{
    // Space for labels at the sides, for the legend above and the scale below.
    private const double LegendBottom = 46, Side = 56, Above = 64, Below = 84, LeastWidth = 300;

    private double Width => Math.Max(LeastWidth, ((scene.High.X - scene.Low.X) * scene.PixelsPerMm) + (2 * Side));

    private double Height => ((scene.High.Y - scene.Low.Y) * scene.PixelsPerMm) + Above + Below;

    /// <summary>Writes the drawing.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    /// <param name="title">Its title.</param>
    public void Write(HtmlText html, string id, string title)
    {
        using (SvgShapes.Drawing(html, id, "assembly", (Width, Height), title, Describe()))
        {
            WriteHatch(html, id);
            WriteEdge(html, p => p.Part, AssemblyScene.EdgePixels, "part edge", $"url(#{id}-hatch)");
            WriteEdge(html, counterpart, -AssemblyScene.EdgePixels, "counterpart edge", null);
            WriteOutline(html, p => p.Part, "part outline");
            WriteOutline(html, counterpart, "counterpart outline");
            WriteKeyPoints(html);
            WriteLegend(html, id, title);
            WriteScale(html);
        }
    }

    private string Describe()
    {
        var worst = scene.Features.SelectMany(f => f.Points).MaxBy(p => Math.Abs(Error(p)))!;
        return $"Outlines of part and counterpart, deviations {scene.FactorText}. The largest mating error is "
            + $"{worst.ErrorWords(counterpart(worst))} at point {worst.Label}: {(Error(worst) > 0 ? "the pieces overlap" : "a gap")}.";
    }

    private double Error(DrawnPoint point) => counterpart(point) - point.Part;

    /// <summary>Position in the drawing: Y up, horizontally centered.</summary>
    internal (double X, double Y) Place(Point2 point)
    {
        var left = (Width - ((scene.High.X - scene.Low.X) * scene.PixelsPerMm)) / 2;
        return (left + ((point.X - scene.Low.X) * scene.PixelsPerMm), Above + ((scene.High.Y - point.Y) * scene.PixelsPerMm));
    }

    private static void WriteHatch(HtmlText html, string id)
    {
        using (html.In("defs"))
        using (html.In(
            "pattern",
            ("id", id + "-hatch"),
            ("width", "5"),
            ("height", "5"),
            ("patternUnits", "userSpaceOnUse"),
            ("patternTransform", "rotate(45)")))
        {
            html.Empty("line", ("class", "part hatch"), ("x1", "0"), ("y1", "0"), ("x2", "0"), ("y2", "5"));
        }
    }

    private void WriteEdge(HtmlText html, Func<DrawnPoint, double> deviation, double asidePixels, string cssClass, string? fill)
    {
        foreach (var (line, inside) in scene.Displaced(deviation).Zip(scene.Displaced(deviation, asidePixels)))
        {
            html.Empty(
                "polygon", ("class", cssClass), ("fill", fill), ("points", SvgNumber.Points(line.Concat(inside.Reverse()).Select(Place))));
        }
    }

    private void WriteOutline(HtmlText html, Func<DrawnPoint, double> deviation, string cssClass)
    {
        foreach (var line in scene.Displaced(deviation))
        {
            html.Empty("polyline", ("class", cssClass), ("points", SvgNumber.Points(line.Select(Place))));
        }
    }

    private void WriteKeyPoints(HtmlText html)
    {
        const double aside = AssemblyScene.EdgePixels + 14, near = 13;
        var labels = new List<(double X, double Y)>();
        foreach (var (feature, point) in scene.Features.SelectMany(f => f.Points.Select(p => (f, p))))
        {
            var (x, y) = Place(feature.Foot(point) + (point.Normal * (scene.Factor * point.Part)));
            SvgShapes.Circle(
                html, "key-point", x, y, 2.6, $"Point {point.Label}: mating error {point.ErrorWords(counterpart(point))}");
            var label = (X: x + (point.Normal.X * aside), Y: y - (point.Normal.Y * aside));
            if (label.Y > LegendBottom + near && labels.All(l => Math.Abs(l.X - label.X) > 1.6 * near || Math.Abs(l.Y - label.Y) > near))
            {
                labels.Add(label);
                SvgShapes.Text(html, "tick", label.X, label.Y + 4, "middle", SvgNumber.Label(point.Label, 6));
            }
        }
    }

    private void WriteLegend(HtmlText html, string id, string title)
    {
        SvgShapes.Text(html, "drawing-title", Width / 2, 16, "middle", title);
        var left = (Width - LeastWidth) / 2;
        html.Empty(
            "rect",
            ("class", "part edge"),
            ("fill", $"url(#{id}-hatch)"),
            ("x", SvgNumber.Of(left + 20)),
            ("y", "28"),
            ("width", "34"),
            ("height", "11"));
        SvgShapes.Line(html, "part outline", left + 20, 39, left + 54, 39);
        SvgShapes.Text(html, "legend", left + 61, 38, "start", "part");
        html.Empty("rect", ("class", "counterpart edge"), ("x", SvgNumber.Of(left + 140)), ("y", "28"), ("width", "34"), ("height", "11"));
        SvgShapes.Line(html, "counterpart outline", left + 140, 28, left + 174, 28);
        SvgShapes.Text(html, "legend", left + 181, 38, "start", "counterpart");
    }

    /// <summary>Two bars, one for the boundary and one for the deviations, because the drawing has two scales.</summary>
    private void WriteScale(HtmlText html)
    {
        var shape = RoundNumber.AtMost(90 / scene.PixelsPerMm);
        Bar(Height - 50, shape * scene.PixelsPerMm, $"{ReportNumber.Short(shape)} mm of the outline");
        if (scene.LargestMm > 0)
        {
            var deviation = RoundNumber.AtLeast(scene.LargestMm);
            Bar(Height - 30, deviation * scene.PixelsPerMm * scene.Factor, $"{ReportNumber.Short(deviation)} mm of deviation");
        }

        SvgShapes.Text(
            html,
            "factor",
            (Width - LeastWidth) / 2 + 8,
            Height - 8,
            "start",
            scene.Factor == 1 ? "Deviations true to scale" : $"Deviations exaggerated {scene.FactorText}");

        void Bar(double y, double length, string text)
        {
            var x = ((Width - LeastWidth) / 2) + 8;
            html.Empty("path", ("class", "scale"), ("d", $"M{SvgNumber.Of(x)} {SvgNumber.Of(y - 4)}v8m0 -4h{SvgNumber.Of(length)}m0 -4v8"));
            SvgShapes.Text(html, "legend", x + length + 8, y + 4, "start", text);
        }
    }
}
