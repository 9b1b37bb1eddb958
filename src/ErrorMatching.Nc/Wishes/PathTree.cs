using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Bounding boxes around motions, boxes around pairs of boxes, and so on up to one, to find what is near a place without
/// visiting all motions. Pairs are neighbors on the path, so they are also close on the piece.</summary>
internal sealed class PathTree
{
    /// <summary>Far more than boxes and feet differ by rounding, mm.</summary>
    private const double Slack = 1e-9;

    private readonly NcPath _path;
    private readonly int[] _motions;
    private readonly (Point2 Low, Point2 High)[] _boxes;
    private readonly int _leaves;

    /// <summary>Builds a tree over some motions.</summary>
    /// <param name="path">The path.</param>
    /// <param name="motions">Cutting motions that move in the XY plane.</param>
    public PathTree(NcPath path, int[] motions)
    {
        (_path, _motions, _leaves) = (path, motions, 1);
        while (_leaves < motions.Length)
        {
            _leaves *= 2;
        }

        _boxes = new (Point2, Point2)[2 * _leaves];
        Array.Fill(_boxes, (new(double.PositiveInfinity, double.PositiveInfinity), new(double.NegativeInfinity, double.NegativeInfinity)));
        for (var i = 0; i < motions.Length; i++)
        {
            _boxes[_leaves + i] = BoxOf(path.Motions[motions[i]]);
        }

        for (var node = _leaves - 1; node > 0; node--)
        {
            var (a, b) = (_boxes[2 * node], _boxes[(2 * node) + 1]);
            _boxes[node] = (
                new(Math.Min(a.Low.X, b.Low.X), Math.Min(a.Low.Y, b.Low.Y)),
                new(Math.Max(a.High.X, b.High.X), Math.Max(a.High.Y, b.High.Y)));
        }
    }

    /// <summary>The motion nearest to a place; the first if several are equally near.</summary>
    public PathFoot NearestTo(Point2 place)
    {
        var best = new PathFoot(double.PositiveInfinity, _motions[0], 0);
        Visit(1, place, ref best);
        return best;
    }

    /// <summary>Collects all motions within a distance of a place, in path order.</summary>
    public void Collect(Point2 place, double distance, List<PathFoot> feet)
    {
        feet.Clear();
        Collect(1, place, distance, feet);
    }

    private void Collect(int node, Point2 place, double distance, List<PathFoot> feet)
    {
        if (!(DistanceTo(node, place) <= distance + Slack))
        {
            return;
        }

        if (node < _leaves)
        {
            Collect(2 * node, place, distance, feet);
            Collect((2 * node) + 1, place, distance, feet);
        }
        else if (FootOn(node, place) is var foot && foot.DistanceMm <= distance)
        {
            feet.Add(foot);
        }
    }

    private void Visit(int node, Point2 place, ref PathFoot best)
    {
        if (!(DistanceTo(node, place) <= best.DistanceMm + Slack))
        {
            return;
        }

        if (node >= _leaves)
        {
            var foot = FootOn(node, place);
            best = foot.DistanceMm < best.DistanceMm || (foot.DistanceMm == best.DistanceMm && foot.Motion < best.Motion) ? foot : best;
            return;
        }

        var first = DistanceTo(2 * node, place) <= DistanceTo((2 * node) + 1, place) ? 0 : 1;
        Visit((2 * node) + first, place, ref best);
        Visit((2 * node) + 1 - first, place, ref best);
    }

    private PathFoot FootOn(int leaf, Point2 place)
    {
        var index = _motions[leaf - _leaves];
        var motion = _path.Motions[index];
        var fraction = motion.IsArc ? motion.Arc.NearestFraction(place) : motion.Segment.NearestFraction(place);
        return new(motion.PlaneAt(fraction).DistanceTo(place), index, fraction);
    }

    private double DistanceTo(int node, Point2 place)
    {
        var (low, high) = _boxes[node];
        var (x, y) = (Math.Max(0, Math.Max(low.X - place.X, place.X - high.X)), Math.Max(0, Math.Max(low.Y - place.Y, place.Y - high.Y)));
        return Math.Sqrt((x * x) + (y * y));
    }

    // An arc is inside its circle's box, but its ends may be slightly outside.
    private static (Point2 Low, Point2 High) BoxOf(in NcMotion motion)
    {
        var (a, b) = (motion.PlaneStart, motion.PlaneEnd);
        var (low, high) = (new Point2(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y)), new Point2(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y)));
        if (!motion.IsArc)
        {
            return (low, high);
        }

        var (c, r) = (motion.Center, Math.Max(motion.Center.DistanceTo(a), motion.Center.DistanceTo(b)));
        return (new(Math.Min(low.X, c.X - r), Math.Min(low.Y, c.Y - r)), new(Math.Max(high.X, c.X + r), Math.Max(high.Y, c.Y + r)));
    }
}

/// <summary>The point of a motion that is nearest to a place.</summary>
/// <param name="DistanceMm">Its distance, mm.</param>
/// <param name="Motion">The motion.</param>
/// <param name="Fraction">Its position on the motion, 0 to 1.</param>
internal readonly record struct PathFoot(double DistanceMm, int Motion, double Fraction);
