using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Finds where a contour closes: where it returns to a place and has not touched itself in between. A few
/// searches walk along the contour. For many, all joints of the path are sorted
/// by place once, so the cost grows linearly with the program, not with its square.</summary>
internal sealed class ContourSearch
{
    /// <summary>Up to this number of searches, walking is used instead of sorting.</summary>
    private const int Few = 8;

    /// <summary>Size of the cubes into which places are sorted, mm; their centers are on the grid of programmed coordinates.</summary>
    private const double CellMm = 1e-4;

    private readonly NcMotions _motions;
    private readonly double _tolerance;
    private readonly bool _isSorted;
    private readonly Func<int, bool>? _passes;
    private readonly int[] _breaks = [];
    private readonly Dictionary<int, ContourTouches?> _touches = [];
    private ulong[]? _ends;
    private ulong[]? _starts;

    /// <summary>Creates a search in a path.</summary>
    /// <param name="motions">The path.</param>
    /// <param name="tolerance">Places closer than this are the same, mm; less than half of <see cref="CellMm"/>.</param>
    /// <param name="searches">Number of searches that will follow.</param>
    /// <param name="passes">Motions that do not move in the plane and do not interrupt a contour; null if there are none.</param>
    public ContourSearch(NcMotions motions, double tolerance, int searches, Func<int, bool>? passes = null)
    {
        (_motions, _tolerance, _isSorted, _passes) = (motions, tolerance, searches > Few, passes);
        if (_isSorted)
        {
            var breaks = new List<int>();
            for (var i = 0; i < motions.Length; i++)
            {
                if (i == 0 || !IsContour(i) || !IsContour(i - 1) || !motions.IsComparable(i, i - 1))
                {
                    breaks.Add(i);
                }
            }

            _breaks = [.. breaks];
        }
    }

    /// <summary>The first motion from a position on that ends at a place, with only cuts of one contour before it, which do not touch;
    /// -1 if none.</summary>
    /// <param name="place">The place.</param>
    /// <param name="from">The first motion to check.</param>
    /// <param name="first">The motion that begins at the place.</param>
    public int FirstEndingAt(Point3 place, int from, int first) =>
        EndingAt(place, from, first) is >= 0 and var found && AreApart(Math.Max(from, first + 1), found) ? found : -1;

    /// <summary>The last motion up to a position that begins at a place, with only cuts of one contour after it, which do not touch; -1 if
    /// none.</summary>
    /// <param name="place">The place.</param>
    /// <param name="from">The motion from which to search backwards.</param>
    /// <param name="last">The motion that ends at the place.</param>
    public int LastStartingAt(Point3 place, int from, int last) =>
        StartingAt(place, from, last) is >= 0 and var found && AreApart(found + 1, Belongs(last, from) ? last : from) ? found : -1;

    // The cut that begins at the place is left out: the one that closes the contour touches it.
    private bool AreApart(int first, int last)
    {
        if (last - first < 2)
        {
            return true;
        }

        if (!_isSorted)
        {
            return ContourTouches.Of(_motions, first, last)?.IsSimple(first, last) ?? true;
        }

        var begin = FirstOf(first);
        if (!_touches.TryGetValue(begin, out var touches))
        {
            _touches.Add(begin, touches = ContourTouches.Of(_motions, begin, LastOf(first)));
        }

        return touches?.IsSimple(first, last) ?? true;
    }

    private int EndingAt(Point3 place, int from, int like)
    {
        if (from >= _motions.Length || !Belongs(from, like))
        {
            return -1;
        }

        if (_isSorted)
        {
            _ends ??= Sort(_motions.EndOf);
            return Find(_ends, _motions.EndOf, place, from, LastOf(from), ahead: true);
        }

        return WalkAhead(place, from, like);
    }

    private int StartingAt(Point3 place, int from, int like)
    {
        if (from < 0 || !Belongs(from, like))
        {
            return -1;
        }

        if (_isSorted)
        {
            _starts ??= Sort(_motions.StartOf);
            return Find(_starts, _motions.StartOf, place, FirstOf(from), from, ahead: false);
        }

        return WalkBack(place, from, like);
    }

    private int WalkAhead(Point3 place, int from, int like)
    {
        for (var i = from; (i = _motions.PassAhead(i, like, place, _tolerance)) < _motions.Length && Belongs(i, like); i++)
        {
            if (IsSame(_motions.EndOf(i), place) && _motions.IsContour(i))
            {
                return i;
            }
        }

        return -1;
    }

    private int WalkBack(Point3 place, int from, int like)
    {
        for (var i = from; i >= 0 && Belongs(i = _motions.PassBack(i, like, place, _tolerance), like); i--)
        {
            if (IsSame(_motions.StartOf(i), place) && _motions.IsContour(i))
            {
                return i;
            }
        }

        return -1;
    }

    private bool IsContour(int motion) => _motions.IsContour(motion) || (_passes is not null && _passes(motion));

    private bool Belongs(int motion, int like) => IsContour(motion) && _motions.IsComparable(motion, like);

    private bool IsSame(Point3 a, Point3 b) => Math.Abs(a.X - b.X) < _tolerance && (a - b).Length < _tolerance;

    private int FirstOf(int motion)
    {
        var at = Array.BinarySearch(_breaks, motion);
        return _breaks[at >= 0 ? at : ~at - 1];
    }

    private int LastOf(int motion)
    {
        var at = Array.BinarySearch(_breaks, motion);
        var next = at >= 0 ? at + 1 : ~at;
        return next < _breaks.Length ? _breaks[next] - 1 : _motions.Length - 1;
    }

    // A key has the cell in its upper half and the motion in its lower half, so motions of a cell are adjacent and in path order.
    private ulong[] Sort(Func<int, Point3> placeOf)
    {
        var keys = new ulong[_motions.Length];
        for (var i = 0; i < keys.Length; i++)
        {
            var place = placeOf(i);
            keys[i] = Key(Cell(place.X), Cell(place.Y), Cell(place.Z), i);
        }

        Array.Sort(keys);
        return keys;
    }

    private int Find(ulong[] keys, Func<int, Point3> placeOf, Point3 place, int first, int last, bool ahead)
    {
        var best = -1;
        for (var x = Cell(place.X - _tolerance); x <= Cell(place.X + _tolerance); x++)
        {
            for (var y = Cell(place.Y - _tolerance); y <= Cell(place.Y + _tolerance); y++)
            {
                for (var z = Cell(place.Z - _tolerance); z <= Cell(place.Z + _tolerance); z++)
                {
                    var found = FindInCell(keys, placeOf, place, Key(x, y, z, first), Key(x, y, z, last), ahead);
                    best = best < 0 || (found >= 0 && (ahead ? found < best : found > best)) ? found : best;
                }
            }
        }

        return best;
    }

    private int FindInCell(ulong[] keys, Func<int, Point3> placeOf, Point3 place, ulong first, ulong last, bool ahead)
    {
        var at = Array.BinarySearch(keys, ahead ? first : last);
        for (at = at >= 0
            ? at
            : ahead
            ? ~at
            : ~at - 1; at >= 0 && at < keys.Length && keys[at] >= first && keys[at] <= last; at += ahead
            ? 1
            : -1)
        {
            var motion = (int)(uint)keys[at];
            if (IsSame(placeOf(motion), place) && _motions.IsContour(motion))
            {
                return motion;
            }
        }

        return -1;
    }

    // Far outside any machine, all places share one cell.
    private static long Cell(double coordinate) => (long)Math.Clamp(Math.Floor((coordinate / CellMm) + 0.5), -1e18, 1e18);

    private static ulong Key(long x, long y, long z, int motion)
    {
        const ulong Mix = 0x9E3779B97F4A7C15;
        var hash = (((((ulong)x * Mix) + (ulong)y) * Mix) + (ulong)z) * Mix;
        return (hash & 0xFFFFFFFF00000000) | (uint)motion;
    }
}
