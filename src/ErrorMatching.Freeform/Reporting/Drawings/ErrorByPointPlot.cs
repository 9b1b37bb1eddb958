using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Plots error by point number before and after, as in figures 10 to 12 of Lee 2019: circles before, plus signs after.</summary>
/// <param name="points">The points in the order of measuring.</param>
internal sealed class ErrorByPointPlot(IReadOnlyList<PlottedError> points)
{
    private readonly PointPlot _plot = new(
        PlotAxis.Around(points.SelectMany(p => new[] { p.BeforeUm, p.AfterUm ?? p.BeforeUm })), [.. points.Select(p => p.Label)])
    {
        Size = (820, 340),
        Left = 74,
        Right = 800,
        Top = 40,
        Bottom = 290,
    };

    /// <summary>Writes the drawing.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    /// <param name="title">Title of the drawing.</param>
    /// <param name="before">Legend of the circles.</param>
    /// <param name="after">Legend of the plus signs.</param>
    public void Write(HtmlText html, string id, string title, string before, string after)
    {
        var description = $"{before}: largest {Largest(p => p.BeforeUm)}. {after}: largest {Largest(p => p.AfterUm ?? 0)}.";
        using (SvgShapes.Drawing(html, id, "plot", _plot.Size, title, description))
        {
            _plot.WriteGrid(html, Micrometres.Signed);
            _plot.WriteAxes(html, "Point, in the order of measuring", 12, "Error along the normal, µm");
            for (var i = 0; i < points.Count; i++)
            {
                var (label, was, becomes) = points[i];
                WriteCircle(html, _plot.X(i), _plot.Y(was), $"Point {label}, {before}: {Micrometres.Signed(was)} µm");
                if (becomes is { } value)
                {
                    WritePlus(html, _plot.X(i), _plot.Y(value), $"Point {label}, {after}: {Micrometres.Signed(value)} µm");
                }
            }

            WriteCircle(html, _plot.Left + 8, 16, null);
            SvgShapes.Text(html, "legend", _plot.Left + 20, 20, "start", before);
            WritePlus(html, _plot.Middle + 8, 16, after);
            SvgShapes.Text(html, "legend", _plot.Middle + 20, 20, "start", after);
        }
    }

    private static void WriteCircle(HtmlText html, double x, double y, string? title) =>
        SvgShapes.Circle(html, "before marker", x, y, 4, title);

    private static void WritePlus(HtmlText html, double x, double y, string title) => SvgShapes.Plus(html, "after marker", x, y, title);

    private string Largest(Func<PlottedError, double> value)
    {
        var point = points.MaxBy(p => Math.Abs(value(p)))!;
        return $"{Micrometres.Signed(value(point))} µm at point {point.Label}";
    }
}
