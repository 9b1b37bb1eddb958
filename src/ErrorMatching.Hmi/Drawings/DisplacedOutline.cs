using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>The boundary of a feature, displaced along its normals by the amounts at its key points and interpolated linearly
/// along the boundary between them.</summary>
internal sealed class DisplacedOutline
{
    // Corners closer than this are one, mm.
    private const double LeastShare = 0.000001;

    private readonly List<Point2> _outline;
    private readonly double[] _at;
    private readonly double[] _feet;
    private readonly double _side;

    /// <summary>Takes a boundary of two or more points and its key points in the order of cutting.</summary>
    public DisplacedOutline(IReadOnlyList<Point2> outline, IReadOnlyList<(Point2 At, Vector2 Normal)> points)
    {
        // Adds a corner at the foot of each key point, so that even a long straight gets the exact displacement there.
        _outline = [.. outline];
        foreach (var (at, _) in points)
        {
            var (segment, foot) = FootOf(at);
            if (foot.DistanceTo(_outline[segment]) > LeastShare && foot.DistanceTo(_outline[segment + 1]) > LeastShare)
            {
                _outline.Insert(segment + 1, foot);
            }
        }

        _at = new double[_outline.Count];
        for (var i = 1; i < _outline.Count; i++)
        {
            _at[i] = _at[i - 1] + _outline[i].DistanceTo(_outline[i - 1]);
        }

        _feet = [.. points.Select(p => _at[Nearest(FootOf(p.At).Foot)])];
        _side = points.Count > 0 && NormalAt(Nearest(FootOf(points[0].At).Foot)).Dot(points[0].Normal) < 0 ? -1 : 1;
    }

    /// <summary>The displaced boundary.</summary>
    /// <param name="amounts">Displacement at each key point along its normal, mm.</param>
    public IReadOnlyList<Point2> By(double[] amounts) =>
        [.. _outline.Select((p, i) => p + (_side * Between(_at[i], amounts) * NormalAt(i)))];

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

    // The nearest place on all segments, and the segment that it is on.
    private (int Segment, Point2 Foot) FootOf(Point2 place)
    {
        var (found, nearest) = (0, _outline[0]);
        for (var i = 0; i + 1 < _outline.Count; i++)
        {
            var (from, way) = (_outline[i], _outline[i + 1] - _outline[i]);
            var foot = way.Length > 0 ? from + (Math.Clamp((place - from).Dot(way) / way.Dot(way), 0, 1) * way) : from;
            if (foot.DistanceTo(place) < nearest.DistanceTo(place))
            {
                (found, nearest) = (i, foot);
            }
        }

        return (found, nearest);
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

    // To the left of the direction of travel, perpendicular to the chord between the neighboring corners.
    private Vector2 NormalAt(int i)
    {
        var way = _outline[Math.Min(i + 1, _outline.Count - 1)] - _outline[Math.Max(i - 1, 0)];
        return way.Length > 0 ? new Vector2(-way.Y, way.X) / way.Length : new Vector2(0, 0);
    }
}
