using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The edges of a region's loops by bands of v, so that a place is looked for among few of them. Memory grows with the number of edges, however long they are.</summary>
internal sealed class RegionBands
{
    // An edge lies in five bands in the mean, at most.
    private const int Share = 4;

    private readonly double _first, _height;
    private readonly (Point2 A, Point2 B, int Loop, int Side)[][] _bands;

    /// <summary>The bands of some loops.</summary>
    public RegionBands(IReadOnlyList<IReadOnlyList<Point2>> loops)
    {
        var edges = new List<(Point2 A, Point2 B, int Loop, int Side)>();
        for (var k = 0; k < loops.Count; k++)
        {
            var loop = loops[k];
            for (var i = 0; i < loop.Count; i++)
            {
                if (loop[i].Y != loop[(i + 1) % loop.Count].Y)
                {
                    edges.Add((loop[i], loop[(i + 1) % loop.Count], k, i));
                }
            }
        }

        if (edges.Count == 0)
        {
            _bands = [];
            return;
        }

        var (last, rise) = (double.NegativeInfinity, 0.0);
        _first = double.PositiveInfinity;
        foreach (var (a, b, _, _) in edges)
        {
            (_first, last, rise) = (Math.Min(_first, Math.Min(a.Y, b.Y)), Math.Max(last, Math.Max(a.Y, b.Y)), rise + Math.Abs(b.Y - a.Y));
        }

        var count = Math.Max(1, (int)Math.Min(edges.Count, Share * edges.Count * ((last - _first) / rise)));
        _height = (last - _first) / count;
        var bands = new List<(Point2, Point2, int, int)>[count];
        for (var i = 0; i < count; i++)
        {
            bands[i] = [];
        }

        foreach (var edge in edges)
        {
            var end = BandOf(Math.Max(edge.A.Y, edge.B.Y), count);
            for (var i = BandOf(Math.Min(edge.A.Y, edge.B.Y), count); i <= end; i++)
            {
                bands[i].Add(edge);
            }
        }

        _bands = [.. bands.Select(b => b.ToArray())];
    }

    /// <summary>True if a place lies inside an odd number of the loops.</summary>
    public bool Contains(double u, double v)
    {
        var inside = false;
        if (_bands.Length > 0 && v >= _first)
        {
            foreach (var (a, b, _, _) in _bands[BandOf(v, _bands.Length)])
            {
                inside ^= a.Y > v != b.Y > v && u < a.X + ((b.X - a.X) * ((v - a.Y) / (b.Y - a.Y)));
            }
        }

        return inside;
    }

    /// <summary>How often each loop goes round a place, counter-clockwise if positive; loops that do not go round it may be missing.</summary>
    /// <param name="place">The place: on a line of one v, it counts as just above it.</param>
    /// <param name="exceptLoop">Loop of a side that does not count, for places on it.</param>
    /// <param name="exceptSide">That side of its polygon.</param>
    /// <param name="turns">Receives loops and numbers.</param>
    public void Turns(Point2 place, int exceptLoop, int exceptSide, Dictionary<int, int> turns)
    {
        turns.Clear();
        var (u, v) = (place.X, place.Y);
        if (_bands.Length == 0 || v < _first)
        {
            return;
        }

        foreach (var (a, b, loop, side) in _bands[BandOf(v, _bands.Length)])
        {
            if (a.Y > v != b.Y > v && u < a.X + ((b.X - a.X) * ((v - a.Y) / (b.Y - a.Y))) && !(loop == exceptLoop && side == exceptSide))
            {
                turns[loop] = turns.GetValueOrDefault(loop) + (b.Y > a.Y ? 1 : -1);
            }
        }
    }

    // Rounding is the same for edges and places, and grows with v: an edge that reaches over a place is in its band.
    private int BandOf(double v, int count) => (int)Math.Min((v - _first) / _height, count - 1);
}
