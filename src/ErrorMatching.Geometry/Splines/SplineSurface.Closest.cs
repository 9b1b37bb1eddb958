namespace ErrorMatching.Geometry;

/// <content>The closest point.</content>
public sealed partial class SplineSurface
{
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
