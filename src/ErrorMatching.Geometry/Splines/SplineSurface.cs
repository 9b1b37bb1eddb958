using System.Runtime.Intrinsics;

namespace ErrorMatching.Geometry;

/// <summary>A tensor-product B-spline surface in space, rational if it has weights. Lengths in millimeters.</summary>
/// <remarks>Pole (i, j) has the index i * CountV + j. Parameters outside the knots continue the outermost pieces.</remarks>
public sealed class SplineSurface
{
    private readonly SurfacePoles _poles;

    /// <summary>Creates a surface.</summary>
    /// <param name="knotsU">Degree and knots along u.</param>
    /// <param name="knotsV">Degree and knots along v.</param>
    /// <param name="poles">Finite points, in the number that the knots require, v varying fastest.</param>
    /// <param name="weights">One positive number per pole; empty for a nonrational surface.</param>
    /// <exception cref="GeometryException">The counts do not match, a number is not finite, or a weight is not positive.</exception>
    public SplineSurface(KnotVector knotsU, KnotVector knotsV, ReadOnlySpan<Point3> poles, ReadOnlySpan<double> weights = default)
    {
        ArgumentNullException.ThrowIfNull(knotsU);
        ArgumentNullException.ThrowIfNull(knotsV);
        (KnotsU, KnotsV) = (knotsU, knotsV);
        _poles = new(knotsU, knotsV, poles, weights);
    }

    private SplineSurface(SurfaceRows rows, bool isRational)
    {
        var (poles, weights) = SplinePoles.Unflatten(rows.Values, isRational);
        (KnotsU, KnotsV) = (rows.U, rows.V);
        _poles = new(rows.U, rows.V, poles, weights);
    }

    /// <summary>Degree and knots along u.</summary>
    public KnotVector KnotsU { get; }

    /// <summary>Degree and knots along v.</summary>
    public KnotVector KnotsV { get; }

    /// <summary>Number of poles along u.</summary>
    public int CountU => KnotsU.PoleCount;

    /// <summary>Number of poles along v.</summary>
    public int CountV => KnotsV.PoleCount;

    /// <summary>The poles, v varying fastest.</summary>
    public ReadOnlySpan<Point3> Poles => _poles.Points;

    /// <summary>One weight per pole, v varying fastest; empty if the surface is not rational.</summary>
    public ReadOnlySpan<double> Weights => _poles.Weights;

    /// <summary>True if the poles have different weights.</summary>
    public bool IsRational => _poles.IsRational;

    /// <summary>The point at a pair of parameters.</summary>
    public Point3 PointAt(double u, double v) => _poles.PointAt(u, v);

    /// <summary>The point at a pair of parameters, with first and second derivatives.</summary>
    public SurfacePoint At(double u, double v) => _poles.At(u, v);

    /// <summary>Position and derivatives at a pair of parameters.</summary>
    /// <param name="u">First parameter.</param>
    /// <param name="v">Second parameter.</param>
    /// <param name="order">Highest order in each direction.</param>
    /// <param name="result">(order + 1)^2 vectors. Index a * (order + 1) + b receives the derivative of order a in u and b in v if a + b
    /// does not exceed the order. Index 0 is the position as a vector from the origin.</param>
    public void Derivatives(double u, double v, int order, Span<Vector3> result) => _poles.Derivatives(u, v, order, result);

    /// <summary>The points at every pair of parameters of two lists, v varying fastest. Evaluating along u for all poles, then along v, is
    /// faster than separately.</summary>
    /// <param name="us">Parameters along u in any order.</param>
    /// <param name="vs">Parameters along v in any order.</param>
    public Point3[] PointsAt(ReadOnlySpan<double> us, ReadOnlySpan<double> vs) => _poles.PointsAt(us, vs);

    /// <summary>The weighted line at v over one span of u, and its derivative with respect to v, in the basis functions along u.</summary>
    /// <param name="spanU">The span.</param>
    /// <param name="v">The parameter of the line.</param>
    /// <param name="rows">One row of degree + 1 factors for each number of the result.</param>
    /// <param name="place">Receives the line.</param>
    /// <param name="slope">Receives its derivative with respect to v.</param>
    internal void AlongV(int spanU, double v, ReadOnlySpan<double> rows, Span<Vector256<double>> place, Span<Vector256<double>> slope) =>
        _poles.AlongV(spanU, v, rows, place, slope);

    // Other representations of the same surface: other knots, higher degrees, a part, reversed.

    /// <summary>Converts surfaces to <see cref="KnotVector.Common"/> knots in both directions, so that poles with the same index can be
    /// added. The surfaces do not move.</summary>
    /// <remarks>Ranges and knots are handled as in <see cref="SplineCurve.Compatible"/>.</remarks>
    /// <param name="surfaces">At least one.</param>
    /// <exception cref="GeometryException">The list is empty.</exception>
    public static IReadOnlyList<SplineSurface> Compatible(IReadOnlyList<SplineSurface> surfaces)
    {
        ArgumentNullException.ThrowIfNull(surfaces);
        var u = KnotVector.Common([.. surfaces.Select(s => s.KnotsU)]);
        var v = KnotVector.Common([.. surfaces.Select(s => s.KnotsV)]);
        return [.. surfaces.Select(s => s.Each(r => r.Snap(u).ElevateTo(u.Degree).Onto(u), r => r.Snap(v).ElevateTo(v.Degree).Onto(v)))];
    }

    /// <summary>The same surface over knots that contain its own (knot insertion, Oslo algorithm).</summary>
    /// <param name="finerU">Clamped knots of the same degree along u over the same range, or over a part, which gives that part.</param>
    /// <param name="finerV">The same along v.</param>
    /// <exception cref="GeometryException">The knots do not contain the surface's.</exception>
    public SplineSurface WithKnots(KnotVector finerU, KnotVector finerV)
    {
        ArgumentNullException.ThrowIfNull(finerU);
        ArgumentNullException.ThrowIfNull(finerV);
        return Each(r => r.Onto(finerU), r => r.Onto(finerV));
    }

    /// <summary>The same surface, clamped, with an additional knot along u.</summary>
    /// <param name="u">A parameter inside the range.</param>
    /// <param name="times">Number of insertions.</param>
    /// <exception cref="GeometryException">The parameter is not inside, or its multiplicity would exceed degree + 1.</exception>
    public SplineSurface InsertKnotU(double u, int times = 1) => WithKnots(KnotsU.Insert(u, times), KnotsV.Clamp());

    /// <summary>The same surface, clamped, with an additional knot along v.</summary>
    /// <param name="v">A parameter inside the range.</param>
    /// <param name="times">Number of insertions.</param>
    /// <exception cref="GeometryException">The parameter is not inside, or its multiplicity would exceed degree + 1.</exception>
    public SplineSurface InsertKnotV(double v, int times = 1) => WithKnots(KnotsU.Clamp(), KnotsV.Insert(v, times));

    /// <summary>The same surface, clamped, with higher degrees.</summary>
    /// <param name="degreeU">From the surface's degree along u to <see cref="KnotVector.MaxDegree"/>.</param>
    /// <param name="degreeV">The same along v.</param>
    /// <exception cref="GeometryException">A degree is out of range.</exception>
    public SplineSurface ElevateTo(int degreeU, int degreeV) => Each(r => r.ElevateTo(degreeU), r => r.ElevateTo(degreeV));

    /// <summary>The part of the surface between two pairs of parameters.</summary>
    /// <param name="fromU">First parameter along u.</param>
    /// <param name="toU">Last parameter along u.</param>
    /// <param name="fromV">First parameter along v.</param>
    /// <param name="toV">Last parameter along v.</param>
    /// <exception cref="GeometryException">The part is empty or exceeds the surface.</exception>
    public SplineSurface Between(double fromU, double toU, double fromV, double toV) =>
        WithKnots(KnotsU.Between(fromU, toU), KnotsV.Between(fromV, toV));

    /// <summary>The surface before and after a parameter u.</summary>
    /// <param name="u">A parameter inside the range.</param>
    /// <exception cref="GeometryException">The parameter is not inside.</exception>
    public (SplineSurface Before, SplineSurface After) SplitU(double u)
    {
        var v = KnotsV.Clamp();
        return (WithKnots(KnotsU.Between(KnotsU.Start, u), v), WithKnots(KnotsU.Between(u, KnotsU.End), v));
    }

    /// <summary>The surface before and after a parameter v.</summary>
    /// <param name="v">A parameter inside the range.</param>
    /// <exception cref="GeometryException">The parameter is not inside.</exception>
    public (SplineSurface Before, SplineSurface After) SplitV(double v)
    {
        var u = KnotsU.Clamp();
        return (WithKnots(u, KnotsV.Between(KnotsV.Start, v)), WithKnots(u, KnotsV.Between(v, KnotsV.End)));
    }

    /// <summary>The same surface with poles at its corners.</summary>
    public SplineSurface Clamp() => WithKnots(KnotsU.Clamp(), KnotsV.Clamp());

    /// <summary>The surface with u and v exchanged; its normal is reversed.</summary>
    public SplineSurface Swap() => new(_poles.Rows().Swap(), IsRational);

    /// <summary>The surface reversed along u; its normal is reversed.</summary>
    public SplineSurface ReverseU() => Each(r => r.Reverse(), r => r);

    /// <summary>The surface reversed along v; its normal is reversed.</summary>
    public SplineSurface ReverseV() => Each(r => r, r => r.Reverse());

    /// <summary>The same surface over other parameter ranges.</summary>
    /// <param name="startU">New first parameter along u.</param>
    /// <param name="endU">New last parameter along u, larger than the first.</param>
    /// <param name="startV">New first parameter along v.</param>
    /// <param name="endV">New last parameter along v, larger than the first.</param>
    /// <exception cref="GeometryException">A range is empty.</exception>
    public SplineSurface Reparametrize(double startU, double endU, double startV, double endV) =>
        new(KnotsU.Affine(startU, endU), KnotsV.Affine(startV, endV), Poles, Weights);

    /// <summary>The curve on the surface at a parameter u, along v.</summary>
    public SplineCurve CurveAtU(double u)
    {
        var rows = _poles.Rows();
        return SplineCurve.From(new(KnotsV, rows.AlongU().RowAt(u), rows.Size), IsRational);
    }

    /// <summary>The curve on the surface at a parameter v, along u.</summary>
    public SplineCurve CurveAtV(double v)
    {
        var rows = _poles.Rows();
        return SplineCurve.From(new(KnotsU, rows.AlongV().RowAt(v), rows.Size), IsRational);
    }

    /// <summary>The polynomial pieces, v varying fastest, each a Bezier surface over its part of the parameters.</summary>
    public IReadOnlyList<SplineSurface> Pieces() =>
        [.. from u in KnotsU.Spans() from v in KnotsV.Spans() select Piece(u, v)];

    /// <summary>A box that contains the surface: that of its poles.</summary>
    public Box3 Box() => Box3.Around(Clamp().Poles);

    /// <summary>A box that contains a range of pieces: that of the poles that affect them.</summary>
    internal Box3 Box(int firstU, int lastU, int firstV, int lastV)
    {
        var (startV, count) = (firstV - KnotsV.Degree, lastV - firstV + KnotsV.Degree + 1);
        var box = Box3.Around(Poles.Slice(((firstU - KnotsU.Degree) * CountV) + startV, count));
        for (var i = firstU - KnotsU.Degree + 1; i <= lastU; i++)
        {
            var row = Box3.Around(Poles.Slice((i * CountV) + startV, count));
            box = Box3.Around([box.Min, box.Max, row.Min, row.Max]);
        }

        return box;
    }

    /// <summary>One piece as a Bezier surface over its part of the parameters, from the poles that affect it.</summary>
    internal SplineSurface Piece(int spanU, int spanV)
    {
        var (p, q) = (KnotsU.Degree, KnotsV.Degree);
        if ((CountU, CountV) == (p + 1, q + 1))
        {
            return Clamp();
        }

        var (poles, weights) = (new List<Point3>(), new List<double>());
        for (var i = spanU - p; i <= spanU; i++)
        {
            for (var j = spanV - q; j <= spanV; j++)
            {
                poles.Add(Poles[(i * CountV) + j]);
                weights.Add(IsRational ? Weights[(i * CountV) + j] : 1);
            }
        }

        return new SplineSurface(KnotsU.OfPiece(spanU), KnotsV.OfPiece(spanV), [.. poles], [.. weights]).Clamp();
    }

    private SplineSurface Each(Func<SplineRows, SplineRows> alongU, Func<SplineRows, SplineRows> alongV) =>
        new(_poles.Rows().Each(alongU, alongV), IsRational);

    // Knot removal.

    /// <summary>Removes a knot along u once from the clamped surface, moving it as little as possible. The edges at the ends of u do not
    /// move.</summary>
    /// <param name="u">An inner knot.</param>
    /// <returns>The surface, and a bound in millimeters of its displacement at the same parameters: the largest distance between the poles
    /// over the old knots. For a redundant knot, this is only rounding.</returns>
    /// <exception cref="GeometryException">The parameter is not an inner knot, or a new weight would not be positive.</exception>
    public (SplineSurface Surface, double MovedMm) RemoveKnotU(double u) => Remove(r => r.Remove(u), r => r);

    /// <summary>Removes a knot along v once from the clamped surface, as in <see cref="RemoveKnotU"/>.</summary>
    /// <param name="v">An inner knot.</param>
    /// <returns>The surface, and a bound of its displacement in millimeters.</returns>
    /// <exception cref="GeometryException">The parameter is not an inner knot, or a new weight would not be positive.</exception>
    public (SplineSurface Surface, double MovedMm) RemoveKnotV(double v) => Remove(r => r, r => r.Remove(v));

    private (SplineSurface Surface, double MovedMm) Remove(Func<SplineRows, SplineRows> alongU, Func<SplineRows, SplineRows> alongV)
    {
        var (u, v) = (KnotsU.Clamp(), KnotsV.Clamp());
        var old = _poles.Rows().Each(r => r.Onto(u), r => r.Onto(v));
        var less = old.Each(alongU, alongV);
        var back = less.Each(r => r.Onto(u), r => r.Onto(v));
        return (new(less, IsRational), SplinePoles.Moved(old.Values, back.Values, IsRational));
    }

    // Interpolation at Greville parameters.

    /// <summary>The surface over given knots that passes through one point per pole, each at the Greville parameters of its pole.</summary>
    /// <param name="knotsU">Degree and knots along u; the multiplicity of inner knots is at most the degree.</param>
    /// <param name="knotsV">The same along v.</param>
    /// <param name="points">One point per pole, v varying fastest.</param>
    /// <exception cref="GeometryException">The counts do not match, a point is not finite, or a knot is repeated too often.</exception>
    public static SplineSurface AtGreville(KnotVector knotsU, KnotVector knotsV, ReadOnlySpan<Point3> points)
    {
        var through = new SplineSurface(knotsU, knotsV, points);
        return through.Each(SolveAtGreville, SolveAtGreville);
    }

    private static SplineRows SolveAtGreville(SplineRows points)
    {
        var values = (double[])points.Values.Clone();
        new GrevilleSystem(points.Knots).Solve(values, points.Width);
        return points with { Values = values };
    }

    // The closest point.

    private SurfaceCell? _cells;

    /// <summary>The tree of its parts. Two threads may both create it, with identical results.</summary>
    internal SurfaceCell Cells => _cells ??= new(this);

    /// <summary>The point of the surface closest to a given point.</summary>
    /// <remarks>Global, by branch and bound over parts of the surface. The distance found exceeds the smallest one by at most
    /// <see cref="SurfaceFoot.Accuracy"/>. This is at most the tolerance (or the rounding of the coordinates) unless a large part of the
    /// surface is equally close, as from the center of a sphere. The parameters are those of a local minimum, to the last digits of
    /// Newton's method. The bounds are based on derivatives up to the third order, which are inside the hull of their poles
    /// (<see cref="DerivativeBounds"/>). The first searches take longer, because the parts that they examine are cached.</remarks>
    /// <param name="p">The point.</param>
    /// <param name="tolerance">Required accuracy of the distance in millimeters, positive.</param>
    /// <exception cref="GeometryException">The point is not finite or the tolerance not positive.</exception>
    public SurfaceFoot ClosestPoint(Point3 p, double tolerance = 1e-7) => Search(p, tolerance, null);

    /// <summary>The point of the surface closest to a given point, starting from a place that is probably near it, such as the previous
    /// foot on a path. The result is as global and accurate as without it.</summary>
    /// <param name="p">The point.</param>
    /// <param name="nearU">Parameter u at which the search starts.</param>
    /// <param name="nearV">Parameter v at which the search starts.</param>
    /// <param name="tolerance">Required accuracy of the distance in millimeters, positive.</param>
    /// <exception cref="GeometryException">The point or a parameter is not finite or the tolerance not positive.</exception>
    public SurfaceFoot ClosestPoint(Point3 p, double nearU, double nearV, double tolerance = 1e-7)
    {
        if (!double.IsFinite(nearU) || !double.IsFinite(nearV))
        {
            throw new GeometryException(GeometryError.NotFinite, "a parameter to begin at is no finite number");
        }

        return Search(p, tolerance, (nearU, nearV));
    }

    /// <summary>All intersections of a straight line with the surface, by their distance along the line. A line within 1 nm of the surface
    /// counts as touching it.</summary>
    /// <remarks>Complete, by branch and bound: no hit is missed. For the foot of a measured point along its probing direction, use the hit
    /// with the smallest |Along|.</remarks>
    /// <param name="from">A point of the line.</param>
    /// <param name="direction">Nonzero direction of the line.</param>
    /// <exception cref="GeometryException">The point or the direction is not finite, the direction is zero, or the line runs along the
    /// surface.</exception>
    public IReadOnlyList<SurfaceHit> Hits(Point3 from, Vector3 direction) => from.IsFinite
        ? new LineSearch(from, direction.Normalize()).Run(Cells)
        : throw new GeometryException(GeometryError.NotFinite, "the line's point has a coordinate that is no finite number");

    private SurfaceFoot Search(Point3 p, double tolerance, (double U, double V)? near)
    {
        if (!p.IsFinite || !(tolerance > 0))
        {
            throw new GeometryException(
                GeometryError.NotFinite,
                "the point to be projected has a coordinate that is no finite number, or the tolerance is not positive");
        }

        return SurfaceSearch.Run(this, Cells, p, tolerance, near);
    }
}

/// <summary>The point of a surface closest to a given point. Lengths in millimeters.</summary>
/// <param name="At">The point, with derivatives.</param>
/// <param name="Offset">The displacement from it to the given point.</param>
/// <param name="Accuracy">Proven bound: no point of the surface is closer by more than this.</param>
public readonly record struct SurfaceFoot(SurfacePoint At, Vector3 Offset, double Accuracy)
{
    /// <summary>Distance of the given point from the surface.</summary>
    public double Distance => Offset.Length;

    /// <summary>Height of the given point above the surface along its unit normal, negative on the other side.</summary>
    public double Height => Offset.Dot(At.Normal);

    /// <summary>Distance of the given point from the normal line at the foot: 0 if it is perpendicularly above the surface, otherwise the
    /// foot is on an edge.</summary>
    public double OffNormal => (Offset - (At.Normal * Height)).Length;
}
