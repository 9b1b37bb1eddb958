using System.Runtime.CompilerServices;

namespace ErrorMatching.Geometry;

/// <summary>A part of a surface with bounds: a node of the tree for searching closest points and hits. Parts with inner breaks have only a
/// box. Polynomial (or rational) pieces have derivatives at their center and bounds of higher ones. Derivatives are with respect to s and
/// t from -1 to 1 over the cell.</summary>
internal sealed class SurfaceCell
{
    // Maximum number of pieces and their parts cached in a tree. Beyond it, they are recreated for each search.
    private const int Stored = 30_000;

    private readonly int[] _spansU;
    private readonly int[] _spansV;
    private readonly StrongBox<int> _count;
    private SurfaceCell[]? _children;

    public SurfaceCell(SplineSurface surface)
        : this(surface.Clamp(), surface.KnotsU.Clamp().Spans(), surface.KnotsV.Clamp().Spans(), new StrongBox<int>())
    {
    }

    private SurfaceCell(SplineSurface surface, int[] spansU, int[] spansV, StrongBox<int> count)
    {
        (_spansU, _spansV, _count) = (spansU, spansV, count);
        IsPiece = spansU.Length == 1 && spansV.Length == 1;
        Surface = IsPiece ? surface.Piece(spansU[0], spansV[0]) : surface;
        Box = IsPiece ? Box3.Around(Surface.Poles) : surface.Box(spansU[0], spansU[^1], spansV[0], spansV[^1]);
        From = new(surface.KnotsU.Values[spansU[0]], surface.KnotsV.Values[spansV[0]]);
        To = new(surface.KnotsU.Values[spansU[^1] + 1], surface.KnotsV.Values[spansV[^1] + 1]);
        if (!IsPiece)
        {
            return;
        }

        var (u, v) = (Surface.KnotsU, Surface.KnotsV);
        var (halfU, halfV) = (0.5 * (u.End - u.Start), 0.5 * (v.End - v.Start));
        Center = Surface.At(u.Start + halfU, v.Start + halfV);
        (Ds, Dt) = (Center.Du * halfU, Center.Dv * halfV);
        (Dss, Dst, Dtt) = (Center.Duu * (halfU * halfU), Center.Duv * (halfU * halfV), Center.Dvv * (halfV * halfV));
        Bounds = new(Surface, Center.Position, Ds, Dt);
        OffPlane = (0.5 * Bounds[2, 0]) + Bounds[1, 1] + (0.5 * Bounds[0, 2]);
    }

    /// <summary>A piece over its own parameters; the whole surface for a part with inner breaks.</summary>
    public SplineSurface Surface { get; }

    public Box3 Box { get; }

    public Point2 From { get; }

    public Point2 To { get; }

    /// <summary>True if the part has no inner breaks, so that the following properties are valid.</summary>
    public bool IsPiece { get; }

    /// <summary>The point at the middle of the parameters.</summary>
    public SurfacePoint Center { get; }

    /// <summary>First derivative with respect to s at the center.</summary>
    public Vector3 Ds { get; }

    /// <summary>First derivative with respect to t at the center.</summary>
    public Vector3 Dt { get; }

    /// <summary>Second derivative with respect to s at the center.</summary>
    public Vector3 Dss { get; }

    /// <summary>Mixed second derivative at the center.</summary>
    public Vector3 Dst { get; }

    /// <summary>Second derivative with respect to t at the center.</summary>
    public Vector3 Dtt { get; }

    /// <summary>Bounds of the derivatives up to the third order in the whole cell.</summary>
    public DerivativeBounds Bounds { get; } = DerivativeBounds.None;

    /// <summary>Largest distance of the cell's points from Center + s Ds + t Dt at the same s and t (Taylor's theorem).</summary>
    public double OffPlane { get; }

    /// <summary>Bound of the change of first derivatives within the cell, as a share of those at its center.</summary>
    public double Unsteadiness => Math.Max((Bounds[2, 0] + Bounds[1, 1]) / Ds.Length, (Bounds[1, 1] + Bounds[0, 2]) / Dt.Length);

    /// <summary>The two halves, cut at the middle break of the direction with more breaks, or without breaks, at the middle of the
    /// direction that bends more; null if halves can no longer be distinguished.</summary>
    public SurfaceCell[]? Children()
    {
        if (_children is not null)
        {
            return _children;
        }

        var halves = Split();
        if (halves is not null && (!(halves[0].IsPiece || halves[1].IsPiece) || Interlocked.Add(ref _count.Value, 2) <= Stored))
        {
            // Two threads may both create them, with identical results.
            _children = halves;
        }

        return halves;
    }

    /// <summary>A lower bound of the distance of the cell from a point.</summary>
    public double DistanceBound(Point3 p)
    {
        var box = Box.DistanceTo(p);
        return IsPiece ? Math.Max(box, DistanceToParallelogram(p - Center.Position, Ds, Dt) - OffPlane) : box;
    }

    /// <summary>True if the squared distance from a point is provably a convex function of s and t in the cell, so that it has a single
    /// minimum, which descent finds. The test replaces all terms of the second derivatives S_i . S_j + (S - p) . S_ij by their bounds;
    /// they must form a positive definite matrix.</summary>
    public bool IsConvexFrom(Point3 p)
    {
        var d = Center.Position - p;
        var far = d.Length + Ds.Length + Dt.Length + OffPlane;
        var b = Bounds;
        var restS = (0.5 * b[3, 0]) + b[2, 1] + (0.5 * b[1, 2]);
        var restT = (0.5 * b[0, 3]) + b[1, 2] + (0.5 * b[2, 1]);
        var ss = Ds.Dot(Ds) - (2 * (Abs(Ds, Dss) + Abs(Ds, Dst) + (Ds.Length * restS)))
            + d.Dot(Dss) - Abs(Ds, Dss) - Abs(Dt, Dss) - (OffPlane * Dss.Length) - (far * (b[3, 0] + b[2, 1]));
        var tt = Dt.Dot(Dt) - (2 * (Abs(Dt, Dtt) + Abs(Dt, Dst) + (Dt.Length * restT)))
            + d.Dot(Dtt) - Abs(Ds, Dtt) - Abs(Dt, Dtt) - (OffPlane * Dtt.Length) - (far * (b[0, 3] + b[1, 2]));
        if (b[0, 1] == 0)
        {
            // A curve: constant along t.
            return ss > 0;
        }

        if (!(ss > 0 && tt > 0))
        {
            return false;
        }

        var st = Math.Abs(Ds.Dot(Dt) + d.Dot(Dst))
            + Abs(Ds, Dst) + Abs(Ds, Dtt) + (Ds.Length * restT) + Abs(Dt, Dss) + Abs(Dt, Dst) + (Dt.Length * restS)
            + ((b[2, 0] + b[1, 1]) * (b[1, 1] + b[0, 2]))
            + Abs(Ds, Dst) + Abs(Dt, Dst) + (OffPlane * Dst.Length) + (far * (b[2, 1] + b[1, 2]));
        return ss * tt > st * st;
    }

    /// <summary>A lower bound of the distance between a point, relative to the center, and the parallelogram s a + t b with s and t from
    /// -1 to 1.</summary>
    public static double DistanceToParallelogram(Vector3 p, Vector3 a, Vector3 b)
    {
        var (e, f, g) = (a.Dot(a), a.Dot(b), b.Dot(b));
        var (x, y) = (p.Dot(a), p.Dot(b));
        var area = (e * g) - (f * f);
        var flat = !(area > 1e-10 * e * g);
        if (!flat)
        {
            var (s, t) = (((g * x) - (f * y)) / area, ((e * y) - (f * x)) / area);
            if (Math.Abs(s) <= 1 && Math.Abs(t) <= 1)
            {
                return (p - (a * s) - (b * t)).Length;
            }
        }

        // The closest point is on the rim: two sides at s = 1 and -1, two at t = 1 and -1.
        var best = double.PositiveInfinity;
        for (var side = -1; side <= 1; side += 2)
        {
            var t = g > 0 ? Math.Clamp((y - (side * f)) / g, -1, 1) : 0;
            var s = e > 0 ? Math.Clamp((x - (side * f)) / e, -1, 1) : 0;
            best = Math.Min(best, Math.Min((p - (a * side) - (b * t)).Length, (p - (a * s) - (b * side)).Length));
        }

        // The inside of a sliver has no significant digits. It is within half the sliver's width of the rim.
        return flat && area > 0 ? best - Math.Sqrt(area / Math.Max(e, g)) : best;
    }

    private static double Abs(Vector3 a, Vector3 b) => Math.Abs(a.Dot(b));

    private SurfaceCell[]? Split()
    {
        if (!IsPiece)
        {
            var (countU, countV) = (_spansU.Length, _spansV.Length);
            return countU >= countV
                ? [new(Surface, _spansU[..(countU / 2)], _spansV, _count), new(Surface, _spansU[(countU / 2)..], _spansV, _count)]
                : [new(Surface, _spansU, _spansV[..(countV / 2)], _count), new(Surface, _spansU, _spansV[(countV / 2)..], _count)];
        }

        var alongU = BendsAlongU();
        var knots = alongU ? Surface.KnotsU : Surface.KnotsV;
        var at = knots.Start + (0.5 * (knots.End - knots.Start));
        if (!(at > knots.Start && at < knots.End))
        {
            return null;
        }

        var (before, after) = alongU ? Surface.SplitU(at) : Surface.SplitV(at);
        return [
            new(before, before.KnotsU.Spans(), before.KnotsV.Spans(), _count),
            new(after, after.KnotsU.Spans(), after.KnotsV.Spans(), _count)];
    }

    /// <summary>True if the piece bends more along u, or is longer along u and hardly bends.</summary>
    private bool BendsAlongU()
    {
        var (bendU, bendV) = (Bounds[2, 0], Bounds[0, 2]);
        var (longU, longV) = (Bounds[1, 0], Bounds[0, 1]);
        return bendU == bendV || Math.Max(bendU, bendV) < 1e-3 * Math.Max(longU, longV) ? longU >= longV : bendU > bendV;
    }
}
