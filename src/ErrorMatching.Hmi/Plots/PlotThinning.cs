using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Reduces a line to the points that the screen can resolve. Each pixel column keeps its first, lowest, highest and last
/// point; invisible parts are left out.</summary>
/// <remarks>A line of 100,000 points over 1,000 pixels becomes one of at most 4,000. No pixel moves by more than its own width.</remarks>
internal sealed class PlotThinning
{
    private readonly PlotView _view;
    private readonly PlotBox _seen;
    private readonly List<(Point2 At, bool Begins)> _points = [];
    private Point2? _end;

    // The points of the current column; none if it has no number.
    private double _column = double.NaN;
    private Point2 _first, _low, _high, _last;
    private bool _isLowFirst;

    private PlotThinning(PlotView view) =>
        (_view, _seen) = (
            view, new(-DrawnSizes.Beyond, -DrawnSizes.Beyond, view.Width + DrawnSizes.Beyond, view.Height + DrawnSizes.Beyond));

    /// <summary>The points to draw, in screen units; a point that begins a piece is not joined to the previous one.</summary>
    /// <param name="line">The line in plot units; a point that is not finite interrupts it.</param>
    /// <param name="view">The visible part.</param>
    public static IReadOnlyList<(Point2 At, bool Begins)> Of(IReadOnlyList<Point2> line, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(line);
        var thinning = new PlotThinning(view);
        for (var i = 0; i < line.Count; i++)
        {
            thinning.Add(line[i]);
        }

        thinning.EndColumn();
        return thinning._points;
    }

    private void Add(Point2 place)
    {
        if (!place.IsFinite)
        {
            EndColumn();
            _end = null;
            return;
        }

        var at = _view.ToScreen(place);
        var column = Math.Floor(at.X);
        if (column != _column)
        {
            EndColumn();
            (_column, _first, _low, _high, _last, _isLowFirst) = (column, at, at, at, at, true);
            return;
        }

        if (at.Y < _low.Y)
        {
            (_low, _isLowFirst) = (at, false);
        }
        else if (at.Y > _high.Y)
        {
            (_high, _isLowFirst) = (at, true);
        }

        _last = at;
    }

    private void EndColumn()
    {
        if (!double.IsNaN(_column))
        {
            var (one, other) = _isLowFirst ? (_low, _high) : (_high, _low);
            To(_first);
            To(one);
            To(other);
            To(_last);
            _column = double.NaN;
        }
    }

    private void To(Point2 at)
    {
        if (_end is { } from && from != at && _seen.PartOf(from, at) is var (a, b))
        {
            if (_points.Count == 0 || _points[^1].At != a)
            {
                _points.Add((a, true));
            }

            _points.Add((b, false));
        }

        _end = at;
    }
}
