using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Error over point number before and after, with zero and the tolerance limits, like figures 13 and 18 of Wang 2021.</summary>
internal sealed class ErrorPlot
{
    /// <summary>Size of the drawing, and position of the axes.</summary>
    internal const double Width = 820, Height = 360, Left = 74, Right = 716, Top = 52, Bottom = 300;

    // More labels than this would overlap.
    private const int MostLabels = 30;

    private readonly IReadOnlyList<PlotPoint> _points;
    private readonly PlotAxis _axis;

    /// <summary>A plot of some points, at least one.</summary>
    public ErrorPlot(IReadOnlyList<PlotPoint> points)
    {
        _points = points;
        _axis = PlotAxis.Around(points.SelectMany(
            p => p.Limits is { } l ? [p.Before, p.After, l.LowerMm, l.UpperMm] : new[] { p.Before, p.After }));
    }

    /// <summary>Writes the drawing.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    /// <param name="before">Legend of the first line.</param>
    /// <param name="after">Legend of the second line.</param>
    public void Write(HtmlText html, string id, string before, string after)
    {
        using (html.In(
            "svg",
            ("viewBox", $"0 0 {SvgNumber.Of(Width)} {SvgNumber.Of(Height)}"),
            ("role", "img"),
            ("aria-labelledby", $"{id}-t {id}-d"),
            ("class", "plot")))
        {
            html.Put("title", "Mating error at each key point", ("id", id + "-t"));
            html.Put("desc", Describe(before, after), ("id", id + "-d"));
            WriteBands(html);
            WriteAxes(html);
            WriteLimits(html);
            WriteLine(html, "before", p => p.Before, before, Circle);
            WriteLine(html, "after", p => p.After, after, Diamond);
            WriteLegend(html, before, after);
        }
    }

    /// <summary>Horizontal position of a point.</summary>
    internal double X(double index) => Left + ((index + 0.5) * (Right - Left) / _points.Count);

    /// <summary>Vertical position of a value.</summary>
    internal double Y(double value) => Bottom - ((value - _axis.Lowest) / (_axis.Highest - _axis.Lowest) * (Bottom - Top));

    private string Describe(string before, string after)
    {
        return $"{before}: largest error {Largest(p => p.Before)}. {after}: largest error {Largest(p => p.After)}.";

        string Largest(Func<PlotPoint, double> value)
        {
            var point = _points.MaxBy(p => Math.Abs(value(p)))!;
            return $"{ReportNumber.SignedMm(value(point))} at point {point.Label}";
        }
    }

    private void WriteBands(HtmlText html)
    {
        foreach (var (first, last) in Runs(p => p.Limits))
        {
            if (_points[first].Limits is { } limits)
            {
                var (x1, x2) = (X(first - 0.5), X(last + 0.5));
                html.Empty(
                    "rect",
                    ("class", "band"),
                    ("x", SvgNumber.Of(x1)),
                    ("y", SvgNumber.Of(Y(limits.UpperMm))),
                    ("width", SvgNumber.Of(x2 - x1)),
                    ("height", SvgNumber.Of(Y(limits.LowerMm) - Y(limits.UpperMm))));
            }
        }
    }

    private void WriteLimits(HtmlText html)
    {
        var bands = _points.Select(p => p.Limits).OfType<ToleranceBand>().Distinct().Count();
        ToleranceBand? labelled = null;
        foreach (var (first, last) in Runs(p => p.Limits))
        {
            if (_points[first].Limits is not { } limits)
            {
                continue;
            }

            var (x1, x2) = (X(first - 0.5), X(last + 0.5));
            Line(html, "limit", x1, Y(limits.UpperMm), x2, Y(limits.UpperMm));
            Line(html, "limit", x1, Y(limits.LowerMm), x2, Y(limits.LowerMm));
            // To the right of the plot no line crosses a label. Place labels inside the plot only where the limits change.
            if (labelled != limits)
            {
                var (x, up, down) = bands == 1 ? (Right + 8, 4, 4) : (x1 + 5, -4, 13);
                Text(html, "limit-label", x, Y(limits.UpperMm) + up, "start", "limit " + ReportNumber.Signed(limits.UpperMm));
                Text(html, "limit-label", x, Y(limits.LowerMm) + down, "start", "limit " + ReportNumber.Signed(limits.LowerMm));
                labelled = limits;
            }
        }
    }

    private void WriteAxes(HtmlText html)
    {
        for (var tick = _axis.First; tick <= _axis.Last; tick++)
        {
            var y = Y(tick * _axis.Step);
            Line(html, tick == 0 ? "zero" : "grid", Left, y, Right, y);
            Text(html, "tick", Left - 8, y + 4, "end", ReportNumber.Signed(tick * _axis.Step));
        }

        foreach (var (first, last) in Runs(p => p.Feature))
        {
            if (first > 0)
            {
                Line(html, "border", X(first - 0.5), Top, X(first - 0.5), Bottom);
            }

            Text(
                html,
                "tick",
                (X(first) + X(last)) / 2,
                Top - 6,
                "middle",
                SvgNumber.Label(_points[first].Feature, 2 + ((int)(X(last + 0.5) - X(first - 0.5)) / 8)));
        }

        var every = (_points.Count + MostLabels - 1) / MostLabels;
        for (var i = 0; i < _points.Count; i += every)
        {
            Text(html, "tick", X(i), Bottom + 18, "middle", SvgNumber.Label(_points[i].Label, 6));
        }

        Line(html, "axis", Left, Top, Left, Bottom);
        Text(html, "axis-label", (Left + Right) / 2, Height - 14, "middle", "Key point, in the order of cutting");
        using (html.In(
            "text",
            ("class", "axis-label"),
            ("text-anchor", "middle"),
            ("transform", $"translate(16 {SvgNumber.Of((Top + Bottom) / 2)}) rotate(-90)")))
        {
            html.Text("Mating error, mm");
        }
    }

    private void WriteLine(
        HtmlText html, string cssClass, Func<PlotPoint, double> value, string name, Action<HtmlText, string, double, double, string> marker)
    {
        html.Empty("polyline", ("class", cssClass + " line"), ("points", SvgNumber.Points(_points.Select((p, i) => (X(i), Y(value(p)))))));
        for (var i = 0; i < _points.Count; i++)
        {
            marker(
                html,
                cssClass + " marker",
                X(i),
                Y(value(_points[i])),
                $"Point {_points[i].Label}, {name}: {ReportNumber.SignedMm(value(_points[i]))}");
        }
    }

    private static void WriteLegend(HtmlText html, string before, string after)
    {
        const double y = 16;
        Line(html, "before line", Left, y, Left + 40, y);
        Circle(html, "before marker", Left + 20, y, before);
        Text(html, "legend", Left + 48, y + 4, "start", before);
        var middle = (Left + Right) / 2;
        Line(html, "after line", middle, y, middle + 40, y);
        Diamond(html, "after marker", middle + 20, y, after);
        Text(html, "legend", middle + 48, y + 4, "start", after);
    }

    /// <summary>First and last position of neighbors with a common value.</summary>
    private IEnumerable<(int First, int Last)> Runs<T>(Func<PlotPoint, T> common)
    {
        var first = 0;
        for (var i = 1; i <= _points.Count; i++)
        {
            if (i == _points.Count || !EqualityComparer<T>.Default.Equals(common(_points[i]), common(_points[first])))
            {
                yield return (first, i - 1);
                first = i;
            }
        }
    }

    private static void Circle(HtmlText html, string cssClass, double x, double y, string title)
    {
        using (html.In("circle", ("class", cssClass), ("cx", SvgNumber.Of(x)), ("cy", SvgNumber.Of(y)), ("r", "4")))
        {
            html.Put("title", title);
        }
    }

    private static void Diamond(HtmlText html, string cssClass, double x, double y, string title)
    {
        using (html.In("polygon", ("class", cssClass), ("points", SvgNumber.Points([(x, y - 5), (x + 5, y), (x, y + 5), (x - 5, y)]))))
        {
            html.Put("title", title);
        }
    }

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
