using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Sorts the edges of a region's loops into bands of v, so that only a few are searched for a place. Memory is proportional to
/// the number of edges, regardless of their length.</summary>
internal sealed class RegionBands
{
    // An edge is in at most five bands on average.
    private const int Share = 4;

    private readonly double _first, _height;
    private readonly (Point2 A, Point2 B, int Loop, int Side)[][] _bands;

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

    /// <summary>True if a place is inside an odd number of the loops.</summary>
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

    /// <summary>Returns the winding number of each loop around a place, positive counterclockwise. Loops with winding number 0 may be
    /// missing.</summary>
    /// <param name="place">The place. On a line of constant v, it counts as just above the line.</param>
    /// <param name="exceptLoop">Loop of a side to ignore, for places on it.</param>
    /// <param name="exceptSide">Index of that side in its polygon.</param>
    /// <param name="turns">Receives loops and winding numbers.</param>
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

    // Rounding is identical for edges and places and monotonic in v, so the band of a place contains every edge that spans it.
    private int BandOf(double v, int count) => (int)Math.Min((v - _first) / _height, count - 1);
}
