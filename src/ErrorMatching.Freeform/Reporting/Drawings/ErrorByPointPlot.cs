using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Plots error by point number before and after, as in figures 10 to 12 of Lee 2019: circles before, plus signs after.</summary>
/// <param name="points">The points in the order of measuring.</param>
internal sealed class ErrorByPointPlot(IReadOnlyList<PlottedError> points)
{
    private const double Width = 820, Height = 340, Left = 74, Right = 800, Top = 40, Bottom = 290;
    private const int MostLabels = 30;

    private readonly PlotAxis _axis = PlotAxis.Around(points.SelectMany(p => new[] { p.BeforeUm, p.AfterUm ?? p.BeforeUm }));

    /// <summary>Writes the drawing.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    /// <param name="title">Title of the drawing.</param>
    /// <param name="before">Legend of the circles.</param>
    /// <param name="after">Legend of the plus signs.</param>
    public void Write(HtmlText html, string id, string title, string before, string after)
    {
        using (html.In(
            "svg",
            ("viewBox", $"0 0 {SvgNumber.Of(Width)} {SvgNumber.Of(Height)}"),
            ("role", "img"),
            ("aria-labelledby", $"{id}-t {id}-d"),
            ("class", "plot")))
        {
            html.Put("title", title, ("id", id + "-t"));
            html.Put(
                "desc",
                $"{before}: largest {Largest(p => p.BeforeUm)}. {after}: largest {Largest(p => p.AfterUm ?? 0)}.",
                ("id", id + "-d"));
            WriteAxes(html);
            for (var i = 0; i < points.Count; i++)
            {
                var (label, was, becomes) = points[i];
                using (html.In("circle", ("class", "before marker"), ("cx", SvgNumber.Of(X(i))), ("cy", SvgNumber.Of(Y(was))), ("r", "4")))
                {
                    html.Put("title", $"Point {label}, {before}: {Micrometres.Signed(was)} µm");
                }

                if (becomes is { } value)
                {
                    WritePlus(html, X(i), Y(value), $"Point {label}, {after}: {Micrometres.Signed(value)} µm");
                }
            }

            html.Empty("circle", ("class", "before marker"), ("cx", SvgNumber.Of(Left + 8)), ("cy", "16"), ("r", "4"));
            Text(html, "legend", Left + 20, 20, "start", before);
            WritePlus(html, ((Left + Right) / 2) + 8, 16, after);
            Text(html, "legend", ((Left + Right) / 2) + 20, 20, "start", after);
        }
    }

    private void WriteAxes(HtmlText html)
    {
        for (var tick = _axis.First; tick <= _axis.Last; tick++)
        {
            var y = Y(tick * _axis.Step);
            Line(html, tick == 0 ? "zero" : "grid", Left, y, Right, y);
            Text(html, "tick", Left - 8, y + 4, "end", Micrometres.Signed(tick * _axis.Step));
        }

        var every = (points.Count + MostLabels - 1) / MostLabels;
        for (var i = 0; i < points.Count; i += Math.Max(1, every))
        {
            Text(html, "tick", X(i), Bottom + 18, "middle", SvgNumber.Label(points[i].Label, 6));
        }

        Line(html, "axis", Left, Top, Left, Bottom);
        Text(html, "axis-label", (Left + Right) / 2, Height - 12, "middle", "Point, in the order of measuring");
        using (html.In(
            "text",
            ("class", "axis-label"),
            ("text-anchor", "middle"),
            ("transform", $"translate(16 {SvgNumber.Of((Top + Bottom) / 2)}) rotate(-90)")))
        {
            html.Text("Error along the normal, µm");
        }
    }

    private static void WritePlus(HtmlText html, double x, double y, string title)
    {
        var (left, right) = (SvgNumber.Points([(x - 5, y)]), SvgNumber.Points([(x + 5, y)]));
        var (above, below) = (SvgNumber.Points([(x, y - 5)]), SvgNumber.Points([(x, y + 5)]));
        using (html.In("path", ("class", "after marker"), ("d", $"M{left}L{right}M{above}L{below}")))
        {
            html.Put("title", title);
        }
    }

    private string Largest(Func<PlottedError, double> value)
    {
        var point = points.MaxBy(p => Math.Abs(value(p)))!;
        return $"{Micrometres.Signed(value(point))} µm at point {point.Label}";
    }

    private double X(double index) => Left + ((index + 0.5) * (Right - Left) / points.Count);

    private double Y(double um) => Bottom - ((um - _axis.Lowest) / (_axis.Highest - _axis.Lowest) * (Bottom - Top));

    private static void Line(HtmlText html, string cssClass, double x1, double y1, double x2, double y2) =>
        html.Empty(
            "line",
            ("class", cssClass),
            ("x1", SvgNumber.Of(x1)),
            ("y1", SvgNumber.Of(y1)),
            ("x2", SvgNumber.Of(x2)),
            ("y2", SvgNumber.Of(y2)));

    private static void Text(HtmlText html, string cssClass, double x, double y, string anchor, string text) =>
        html.Put("text", text, ("class", cssClass), ("x", SvgNumber.Of(x)), ("y", SvgNumber.Of(y)), ("text-anchor", anchor));
}
