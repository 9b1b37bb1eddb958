using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>The boundary of a feature, moved along its normals by what is known at its key points, and evenly between them along the boundary.</summary>
internal sealed class DisplacedOutline
{
    private readonly IReadOnlyList<Point2> _outline;
    private readonly double[] _at;
    private readonly double[] _feet;
    private readonly double _side;

    /// <summary>A boundary of two points or more, and its key points in the order of cutting.</summary>
    public DisplacedOutline(IReadOnlyList<Point2> outline, IReadOnlyList<(Point2 At, Vector2 Normal)> points)
    {
        _outline = outline;
        _at = new double[outline.Count];
        for (var i = 1; i < outline.Count; i++)
        {
            _at[i] = _at[i - 1] + outline[i].DistanceTo(outline[i - 1]);
        }

        _feet = [.. points.Select(p => _at[Nearest(p.At)])];
        _side = points.Count > 0 && NormalAt(Nearest(points[0].At)).Dot(points[0].Normal) < 0 ? -1 : 1;
    }

    /// <summary>The boundary, moved.</summary>
    /// <param name="amounts">How far at each key point along its normal, mm.</param>
    public IReadOnlyList<Point2> By(double[] amounts) => [.. _outline.Select((p, i) => p + (_side * Between(_at[i], amounts) * NormalAt(i)))];

    private double Between(double at, double[] amounts)
    {
        if (amounts.Length == 0)
        {
            return 0;
        }

        var next = Array.FindIndex(_feet, f => f >= at);
        if (next <= 0)
        {
            return next == 0 ? amounts[0] : amounts[^1];
        }

        var (from, to) = (_feet[next - 1], _feet[next]);
        return to > from ? amounts[next - 1] + ((amounts[next] - amounts[next - 1]) * (at - from) / (to - from)) : amounts[next];
    }

    private int Nearest(Point2 place)
    {
        var nearest = 0;
        for (var i = 1; i < _outline.Count; i++)
        {
            nearest = _outline[i].DistanceTo(place) < _outline[nearest].DistanceTo(place) ? i : nearest;
        }

        return nearest;
    }

    // To the left of the way, between the pieces that meet there.
    private Vector2 NormalAt(int i)
    {
        var way = _outline[Math.Min(i + 1, _outline.Count - 1)] - _outline[Math.Max(i - 1, 0)];
        return way.Length > 0 ? new Vector2(-way.Y, way.X) / way.Length : new Vector2(0, 0);
    }
}
