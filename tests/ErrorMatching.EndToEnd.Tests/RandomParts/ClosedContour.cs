namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Draws a convex polygon of three to six sides, some corners rounded:
/// counter-clockwise around a boss, clockwise inside a pocket (the material is left of the travel both times). It starts and ends in the
/// middle of a side that belongs to no feature.
/// </summary>
internal sealed class ClosedContour
{
    // A displaced line leaves the circle that it was tangent to; where they meet can lie this far from the tangent point.
    private const double LostTangency = 3;

    private readonly Random _random;
    private readonly double _toolRadius;
    private readonly double _offset;
    private readonly int _turning;
    private readonly int _sides;
    private readonly double[] _turns;
    private readonly double[] _outward;
    private readonly double[] _distance;
    private readonly List<(string Kind, string Shape)> _features = [];
    private readonly (int Feature, int Group)[] _owner;

    private ClosedContour(Random random, double toolRadius, double offset, bool pocket)
    {
        _random = random;
        _toolRadius = toolRadius;
        _offset = offset;
        _turning = pocket ? -1 : 1;
        _sides = random.Next(3, 7);
        _turns = Turns();
        _outward = new double[_sides];
        _distance = new double[_sides];
        _owner = new (int, int)[_sides];
        for (var i = 0; i < _sides; i++)
        {
            _outward[i] = i == 0 ? 0 : _outward[i - 1] + (_turning * _turns[i - 1]);
            _distance[i] = Draw.Between(random, 28, 45);
        }

        Own();
    }

    public static Contour DrawOne(Random random, double toolRadius, double offset, bool pocket)
    {
        while (true)
        {
            if (new ClosedContour(random, toolRadius, offset, pocket).Build() is { } contour)
            {
                return contour;
            }
        }
    }

    private double[] Turns()
    {
        double[] turns;
        do
        {
            var weights = Enumerable.Range(0, _sides).Select(_ => Draw.Between(_random, 0.5, 1)).ToArray();
            turns = [.. weights.Select(w => w * 2 * Math.PI / weights.Sum())];
        }
        while (turns.Max() > 2.2 || turns.Min() < 0.6);
        return turns;
    }

    private void Own()
    {
        Array.Fill(_owner, (ContourPiece.Connector, -1));
        for (var i = 1; i < _sides; i++)
        {
            var drawn = _random.Next(5);
            if (drawn >= 3 && i + 1 < _sides)
            {
                _features.Add(("triangle", "straight"));
                _owner[i] = (_features.Count - 1, 0);
                _owner[++i] = (_features.Count - 1, 1);
            }
            else if (drawn > 0)
            {
                _features.Add(("line", "straight"));
                _owner[i] = (_features.Count - 1, 0);
            }
        }
    }

    private Contour? Build()
    {
        var corners = Enumerable.Range(0, _sides).Select(Rounding).ToArray();
        var pieces = new List<ContourPiece>();
        var vertices = Enumerable.Range(0, _sides).Select(Vertex).ToArray();
        var middle = (vertices[^1] + vertices[0]) * 0.5;
        var at = middle;
        for (var i = 0; i <= _sides; i++)
        {
            var side = i % _sides;
            var last = i == _sides;
            var arc = corners[side];
            var cut = last || arc is null ? 0 : arc.Value.Radius * Math.Tan(_turns[side] / 2);
            var end = last ? middle : vertices[side] - (Heading(side) * cut);
            var (feature, group) = _owner[side];
            var line = new PathLine(at, end, _offset);
            if ((end - at).Dot(Heading(side)) < 3)
            {
                return null;
            }

            var trimIn = i == 0 ? 0 : TrimAt((i - 1) % _sides, corners, feature);
            var trimOut = last ? 0 : TrimAt(side, corners, feature);
            if (group >= 0 && line.BoundaryLength - trimIn - trimOut < 10 + (2 * ContourPiece.Margin))
            {
                return null;
            }

            pieces.Add(new(line, feature, group, trimIn, trimOut));
            at = end;
            if (!last && arc is { } rounded)
            {
                var element = new PathArc(at, Heading(side).Heading, rounded.Radius, _turning * _turns[side], _offset);
                pieces.Add(new(element, rounded.Feature, rounded.Group, 0, 0));
                at = element.End;
            }
        }

        if (_features.Count == 0)
        {
            return null;
        }

        var outside = middle - (Heading(0).Left * 8);
        return new(InOrder(pieces), OrderedFeatures(pieces), outside - (Heading(0) * 2), outside + (Heading(0) * 2));
    }

    /// <summary>The rounding of the corner behind a side: the radius of the path, and the feature it belongs to.</summary>
    private (double Radius, int Feature, int Group)? Rounding(int corner)
    {
        var (before, _) = _owner[corner];
        var (after, groupAfter) = _owner[(corner + 1) % _sides];
        var free = before == ContourPiece.Connector && after == ContourPiece.Connector;
        var inside = before == after && groupAfter == 1;
        var carries = free && _turns[corner] > 1 && Draw.Chance(_random, 0.7);
        if (!carries && !Draw.Chance(_random, inside ? 0.5 : free ? 0.3 : 0.15))
        {
            return null;
        }

        var boundary = carries
            ? Draw.Between(_random, 13, 16)
            : _turning > 0
            ? Draw.Between(_random, 1.5, 5)
            : _toolRadius + Draw.Between(_random, 0.8, 5);
        if (carries)
        {
            _features.Add(("curve", "arc"));
        }

        return (
            boundary + (_turning * _offset), carries ? _features.Count - 1 : inside ? before : ContourPiece.Connector, carries ? 0 : -1);
    }

    private double TrimAt(int corner, (double Radius, int Feature, int Group)?[] corners, int feature) => corners[corner] is { } arc
        ? arc.Feature == feature ? 0 : LostTangency
        : ContourPiece.Trim(_turning * _turns[corner], _offset);

    private Flat Heading(int side) => Flat.Toward(_outward[side] + (_turning * Math.PI / 2));

    /// <summary>Where a side meets the next one.</summary>
    private Flat Vertex(int side)
    {
        var next = (side + 1) % _sides;
        var (a, b) = (Flat.Toward(_outward[side]), Flat.Toward(_outward[next]));
        var across = a.Cross(b);
        return new(
            ((_distance[side] * b.V) - (_distance[next] * a.V)) / across, ((a.U * _distance[next]) - (b.U * _distance[side])) / across);
    }

    // Features are numbered as the tool meets them; rounded corners were drawn behind the sides.
    private static List<int> Order(List<ContourPiece> pieces) => [.. pieces.Select(p => p.Feature).Where(f => f >= 0).Distinct()];

    private static List<ContourPiece> InOrder(List<ContourPiece> pieces)
    {
        var order = Order(pieces);
        return [.. pieces.Select(p => p.Feature < 0 ? p : p with { Feature = order.IndexOf(p.Feature) })];
    }

    private List<(string Kind, string Shape)> OrderedFeatures(List<ContourPiece> pieces) => [.. Order(pieces).Select(f => _features[f])];
}
