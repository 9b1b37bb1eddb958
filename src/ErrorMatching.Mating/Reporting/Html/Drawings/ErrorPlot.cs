using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Error over point number before and after, with zero and the tolerance limits, like figures 13 and 18 of Wang 2021.</summary>
internal sealed class ErrorPlot
{
    private readonly IReadOnlyList<PlotPoint> _points;
    private readonly IReadOnlyList<PlotPlace> _between;
    private readonly PointPlot _plot;

    /// <summary>A plot of some points, at least one.</summary>
    /// <param name="points">The points.</param>
    /// <param name="between">The worst places between them, one of a feature at most.</param>
    public ErrorPlot(IReadOnlyList<PlotPoint> points, IReadOnlyList<PlotPlace>? between = null)
    {
        (_points, _between) = (points, between ?? []);
        _plot = new(
            PlotAxis.Around([
                .. points.SelectMany(p => new[] { p.Before, p.After - (p.Interval95Mm ?? 0), p.After + (p.Interval95Mm ?? 0) }),
                .. points.Select(p => p.Limits).OfType<ToleranceBand>().SelectMany(l => new[] { l.LowerMm, l.UpperMm }),
                .. _between.SelectMany(b => new[] { b.After - b.Interval95Mm, b.After + b.Interval95Mm })]),
            [.. points.Select(p => p.Label)])
        {
            Size = (820, 360),
            Left = 74,
            Right = 716,
            Top = 52,
            Bottom = 300,
        };
    }

    /// <summary>Writes the drawing.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    /// <param name="before">Legend of the first line.</param>
    /// <param name="after">Legend of the second line.</param>
    public void Write(HtmlText html, string id, string before, string after)
    {
        using (SvgShapes.Drawing(html, id, "plot", _plot.Size, "Mating error at each key point", Describe(before, after)))
        {
            WriteBands(html);
            WriteAxes(html);
            WriteLimits(html);
            WriteIntervals(html);
            WriteLine(html, "before", p => p.Before, before, WriteCircle);
            WriteLine(html, "after", p => p.After, after, SvgShapes.Diamond);
            WriteBetween(html);
            WriteLegend(html, before, after);
        }
    }

    private PlotPlace? WorstBetween => _between.MaxBy(b => Math.Abs(b.After));

    private string Describe(string before, string after)
    {
        return $"{before}: largest error {Largest(p => p.Before)}. {after}: largest error {Largest(p => p.After)}."
            + (WorstBetween is { } worst ? $" Between the points: largest error {Words(worst)}." : "");

        string Largest(Func<PlotPoint, double> value)
        {
            var point = _points.MaxBy(p => Math.Abs(value(p)))!;
            return $"{Words(value(point), point.Interval95Mm)} at point {point.Label}";
        }
    }

    private static string Words(double error, double? interval) =>
        interval is { } half ? ReportNumber.Interval(error, half) + " mm" : ReportNumber.SignedMm(error);

    private static string Words(PlotPlace place) => $"{Words(place.After, place.Interval95Mm)} on {place.Feature} near {place.Place}";

    private void WriteIntervals(HtmlText html)
    {
        for (var i = 0; i < _points.Count; i++)
        {
            if (_points[i].Interval95Mm is { } half)
            {
                SvgShapes.Bar(html, "interval", _plot.X(i), _plot.Y(_points[i].After + half), _plot.Y(_points[i].After - half));
            }
        }
    }

    private void WriteBetween(HtmlText html)
    {
        foreach (var place in _between)
        {
            var x = _plot.X(place.Index);
            SvgShapes.Bar(
                html,
                "between interval",
                x,
                _plot.Y(place.After + place.Interval95Mm),
                _plot.Y(place.After - place.Interval95Mm));
            SvgShapes.Plus(html, "between marker", x, _plot.Y(place.After), $"Between the points: {Words(place)}");
        }

        if (WorstBetween is { } worst)
        {
            SvgShapes.Circle(html, "between ring", _plot.X(worst.Index), _plot.Y(worst.After), 9, null);
        }
    }

    private void WriteBands(HtmlText html)
    {
        foreach (var (first, last) in Runs(p => p.Limits))
        {
            if (_points[first].Limits is { } limits)
            {
                var (x1, x2) = (_plot.X(first - 0.5), _plot.X(last + 0.5));
                html.Empty(
                    "rect",
                    ("class", "band"),
                    ("x", SvgNumber.Of(x1)),
                    ("y", SvgNumber.Of(_plot.Y(limits.UpperMm))),
                    ("width", SvgNumber.Of(x2 - x1)),
                    ("height", SvgNumber.Of(_plot.Y(limits.LowerMm) - _plot.Y(limits.UpperMm))));
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

            var (x1, x2) = (_plot.X(first - 0.5), _plot.X(last + 0.5));
            SvgShapes.Line(html, "limit", x1, _plot.Y(limits.UpperMm), x2, _plot.Y(limits.UpperMm));
            SvgShapes.Line(html, "limit", x1, _plot.Y(limits.LowerMm), x2, _plot.Y(limits.LowerMm));
            // To the right of the plot no line crosses a label. Place labels inside the plot only where the limits change.
            if (labelled != limits)
            {
                var (x, up, down) = bands == 1 ? (_plot.Right + 8, 4, 4) : (x1 + 5, -4, 13);
                WriteLimit(html, x, _plot.Y(limits.UpperMm) + up, limits.UpperMm);
                WriteLimit(html, x, _plot.Y(limits.LowerMm) + down, limits.LowerMm);
                labelled = limits;
            }
        }
    }

    private static void WriteLimit(HtmlText html, double x, double y, double limitMm) =>
        SvgShapes.Text(html, "limit-label", x, y, "start", "limit " + ReportNumber.Signed(limitMm));

    private void WriteAxes(HtmlText html)
    {
        _plot.WriteGrid(html, ReportNumber.Signed);
        foreach (var (first, last) in Runs(p => p.Feature))
        {
            var (x1, x2) = (_plot.X(first - 0.5), _plot.X(last + 0.5));
            if (first > 0)
            {
                SvgShapes.Line(html, "border", x1, _plot.Top, x1, _plot.Bottom);
            }

            SvgShapes.Text(
                html,
                "tick",
                (_plot.X(first) + _plot.X(last)) / 2,
                _plot.Top - 6,
                "middle",
                SvgNumber.Label(_points[first].Feature, 2 + ((int)(x2 - x1) / 8)));
        }

        _plot.WriteAxes(html, "Key point, in the order of cutting", 14, "Mating error, mm");
    }

    private void WriteLine(
        HtmlText html, string cssClass, Func<PlotPoint, double> value, string name, Action<HtmlText, string, double, double, string> marker)
    {
        html.Empty(
            "polyline",
            ("class", cssClass + " line"),
            ("points", SvgNumber.Points(_points.Select((p, i) => (_plot.X(i), _plot.Y(value(p)))))));
        for (var i = 0; i < _points.Count; i++)
        {
            marker(
                html,
                cssClass + " marker",
                _plot.X(i),
                _plot.Y(value(_points[i])),
                $"Point {_points[i].Label}, {name}: {Words(value(_points[i]), _points[i].Interval95Mm)}");
        }
    }

    private void WriteLegend(HtmlText html, string before, string after)
    {
        const double y = 16;
        SvgShapes.Line(html, "before line", _plot.Left, y, _plot.Left + 40, y);
        WriteCircle(html, "before marker", _plot.Left + 20, y, before);
        SvgShapes.Text(html, "legend", _plot.Left + 48, y + 4, "start", before);
        var second = _between.Count > 0 ? _plot.Left + 200 : _plot.Middle;
        SvgShapes.Line(html, "after line", second, y, second + 40, y);
        if (_points.Any(p => p.Interval95Mm is not null))
        {
            SvgShapes.Bar(html, "interval", second + 20, y - 9, y + 9);
            after += ", 95 % interval";
        }

        SvgShapes.Diamond(html, "after marker", second + 20, y, after);
        SvgShapes.Text(html, "legend", second + 48, y + 4, "start", after);
        if (WorstBetween is { } worst)
        {
            var third = _plot.Left + 520;
            SvgShapes.Plus(html, "between marker", third, y, "worst place between points");
            SvgShapes.Text(html, "legend", third + 12, y + 4, "start", $"between points, worst on {SvgNumber.Label(worst.Feature, 12)}");
        }
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

    private static void WriteCircle(HtmlText html, string cssClass, double x, double y, string title) =>
        SvgShapes.Circle(html, cssClass, x, y, 4, title);
}
