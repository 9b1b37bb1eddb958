using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>What a small motion of the part does to its gaps: at a place p with the normal n, a shift t and a turn w about the middle
/// change the gap by n . t + w (p x n). The turn is expressed by the way of a typical place, so that all three parts of a motion are
/// lengths of one size.</summary>
internal sealed class PairMotions
{
    /// <summary>Number of parts of a motion: a shift in x and in y, and a turn.</summary>
    public const int Parts = 3;

    /// <summary>Number of limits of the motion itself.</summary>
    public const int Bounds = 2 * Parts;

    // The motion is limited to this part of the outline's size, and to a multiple of the largest gap: what goes further is free.
    private const double BoxShare = 0.25, BoxGaps = 4;

    // What keeps the middle near the centroid in a direction in which no normal determines it.
    private const double Ridge = 1e-9;

    private readonly double[] _changes;

    /// <summary>Prepares the motions of places.</summary>
    /// <param name="places">The places.</param>
    /// <param name="normals">Unit normals there, toward the part.</param>
    /// <param name="largestGapMm">The largest gap, without sign.</param>
    public PairMotions(IReadOnlyList<Point2> places, IReadOnlyList<Vector2> normals, double largestGapMm)
    {
        var centroid = new Point2(places.Average(p => p.X), places.Average(p => p.Y));
        var size = Math.Max(places.Max(p => p.DistanceTo(centroid)), 1e-6);
        Center = MiddleOf(places, normals, centroid, size);
        ArmMm = Math.Max(places.Max(p => p.DistanceTo(Center)), 1e-6);
        BoxMm = Math.Max(BoxShare * size, BoxGaps * largestGapMm);
        Count = places.Count;
        _changes = new double[Parts * Count];
        for (var k = 0; k < Count; k++)
        {
            _changes[Parts * k] = normals[k].X;
            _changes[(Parts * k) + 1] = normals[k].Y;
            _changes[(Parts * k) + 2] = (places[k] - Center).Cross(normals[k]) / ArmMm;
        }
    }

    private PairMotions(PairMotions whole, IReadOnlyList<int> kept)
    {
        (Center, ArmMm, BoxMm, Count) = (whole.Center, whole.ArmMm, whole.BoxMm, kept.Count);
        _changes = [.. kept.SelectMany(k => whole._changes.AsSpan(Parts * k, Parts).ToArray())];
    }

    /// <summary>The place about which the part turns: where the normals meet as nearly as possible, so that a turn shifts least.</summary>
    public Point2 Center { get; }

    /// <summary>The way of a place at this distance stands for a turn.</summary>
    public double ArmMm { get; }

    /// <summary>Largest part of a motion, mm.</summary>
    public double BoxMm { get; }

    /// <summary>Number of places.</summary>
    public int Count { get; }

    /// <summary>The same motions of some of the places.</summary>
    public PairMotions Of(IReadOnlyList<int> kept) => new(this, kept);

    /// <summary>How a motion changes the gap at a place.</summary>
    public double ChangeAt(int place, ReadOnlySpan<double> motion)
    {
        var at = Parts * place;
        return (_changes[at] * motion[0]) + (_changes[at + 1] * motion[1]) + (_changes[at + 2] * motion[2]);
    }

    /// <summary>The limits of a program: the gaps, then those of the motion.</summary>
    public double[] Limits(IReadOnlyList<double> gaps) => [.. gaps, .. Enumerable.Repeat(BoxMm, Bounds)];

    /// <summary>The program of the seat: the largest air at the tightest place. Its unknowns are the air and the motion.</summary>
    /// <param name="first">A place whose gap is small, to start from.</param>
    public LinearProgram Seat(int first)
    {
        const int Unknowns = Parts + 1;
        var rows = new double[Unknowns * (Count + Bounds)];
        for (var k = 0; k < Count; k++)
        {
            rows[Unknowns * k] = 1;
            for (var i = 0; i < Parts; i++)
            {
                rows[(Unknowns * k) + 1 + i] = -_changes[(Parts * k) + i];
            }
        }

        for (var b = 0; b < Bounds; b++)
        {
            rows[(Unknowns * (Count + b)) + 1 + (b / 2)] = b % 2 == 0 ? 1 : -1;
        }

        // The air is bounded by the first place, whose own motion is bounded by the box.
        int[] basis = [first, .. Enumerable.Range(0, Parts).Select(i => BoundOf(i, _changes[(Parts * first) + i]))];
        return new(Unknowns, rows, [1, 0, 0, 0], basis);
    }

    /// <summary>The program of the furthest motion in a direction.</summary>
    /// <param name="direction">The direction.</param>
    /// <param name="more">One more row behind those of the gaps and of the motion; null for none.</param>
    public LinearProgram Furthest(double[] direction, double[]? more = null)
    {
        var rows = new double[Parts * (Count + Bounds + (more is null ? 0 : 1))];
        for (var i = 0; i < _changes.Length; i++)
        {
            rows[i] = -_changes[i];
        }

        for (var b = 0; b < Bounds; b++)
        {
            rows[(Parts * (Count + b)) + (b / 2)] = b % 2 == 0 ? 1 : -1;
        }

        more?.CopyTo(rows, Parts * (Count + Bounds));
        return new(Parts, rows, direction, [.. Enumerable.Range(0, Parts).Select(i => BoundOf(i, direction[i]))]);
    }

    /// <summary>The mean change of all gaps.</summary>
    public double[] MeanChange()
    {
        var mean = new double[Parts];
        for (var i = 0; i < _changes.Length; i++)
        {
            mean[i % Parts] += _changes[i] / Count;
        }

        return mean;
    }

    /// <summary>True for a row that limits the motion itself.</summary>
    public bool IsBound(int row) => row >= Count && row < Count + Bounds;

    private int BoundOf(int part, double direction) => Count + (2 * part) + (direction >= 0 ? 0 : 1);

    // The least squares of (p - c) x n: of a circle its center, whatever part of it is there.
    private static Point2 MiddleOf(IReadOnlyList<Point2> places, IReadOnlyList<Vector2> normals, Point2 centroid, double size)
    {
        var ridge = Ridge * places.Count;
        var (xx, xy, yy, x, y) = (ridge, 0.0, ridge, 0.0, 0.0);
        for (var k = 0; k < places.Count; k++)
        {
            var (row, value) = (new Vector2(normals[k].Y, -normals[k].X), (places[k] - centroid).Cross(normals[k]));
            (xx, xy, yy) = (xx + (row.X * row.X), xy + (row.X * row.Y), yy + (row.Y * row.Y));
            (x, y) = (x + (row.X * value), y + (row.Y * value));
        }

        var way = new Vector2((yy * x) - (xy * y), (xx * y) - (xy * x)) / ((xx * yy) - (xy * xy));
        return way.Length <= 2 * size ? centroid + way : centroid;
    }
}
