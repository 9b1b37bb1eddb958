namespace ErrorMatching.Geometry;

/// <content>The closest place.</content>
public sealed partial class SplineSurface
{
    private SurfaceCell? _cells;

    /// <summary>The tree of its parts. Two threads may both make it; they make the same.</summary>
    internal SurfaceCell Cells => _cells ??= new(this);

    /// <summary>The place of the surface that is closest to a point.</summary>
    /// <remarks>
    /// Global, by branch and bound over parts of the surface: the distance found exceeds the smallest one by no more than <see cref="SurfaceFoot.Accuracy"/>, which is at most the tolerance (or the rounding of the point's
    /// coordinates) unless a great part of the surface is equally close, as from the center of a sphere. The parameters are those of a local minimum to the last digits that Newton's method gives.
    /// The bounds: derivatives up to the third lie in the hull of their poles (<see cref="DerivativeBounds"/>).
    /// The first searches of a surface take longer: the parts that they look at are kept.
    /// </remarks>
    /// <param name="p">The point.</param>
    /// <param name="tolerance">Accuracy wanted of the distance in millimetres, positive.</param>
    /// <exception cref="GeometryException">The point is not finite or the tolerance not positive.</exception>
    public SurfaceFoot ClosestPoint(Point3 p, double tolerance = 1e-7) => Search(p, tolerance, null);

    /// <summary>The place of the surface that is closest to a point, searched from a place that is probably near it, as the foot of the point before on a path. The result is as global and as accurate as without.</summary>
    /// <param name="p">The point.</param>
    /// <param name="nearU">Parameter u to begin at.</param>
    /// <param name="nearV">Parameter v to begin at.</param>
    /// <param name="tolerance">Accuracy wanted of the distance in millimetres, positive.</param>
    /// <exception cref="GeometryException">The point or a parameter is not finite or the tolerance not positive.</exception>
    public SurfaceFoot ClosestPoint(Point3 p, double nearU, double nearV, double tolerance = 1e-7)
    {
        if (!double.IsFinite(nearU) || !double.IsFinite(nearV))
        {
            throw new GeometryException(GeometryError.NotFinite, "a parameter to begin at is no finite number");
        }

        return Search(p, tolerance, (nearU, nearV));
    }

    /// <summary>All places at which a straight line meets the surface, by their distance along it. A line that touches the surface within 1 nm counts as meeting it.</summary>
    /// <remarks>Complete, by branch and bound: no hit is missed between others. For the foot of a measured point along its probing direction, take the one with the smallest |Along|.</remarks>
    /// <param name="from">A point of the line.</param>
    /// <param name="direction">The line's direction, of any length but zero.</param>
    /// <exception cref="GeometryException">The point or the direction is not finite, the direction is zero, or the line runs along the surface.</exception>
    public IReadOnlyList<SurfaceHit> Hits(Point3 from, Vector3 direction) => from.IsFinite
        ? new LineSearch(from, direction.Normalize()).Run(Cells)
        : throw new GeometryException(GeometryError.NotFinite, "the line's point has a coordinate that is no finite number");

    private SurfaceFoot Search(Point3 p, double tolerance, (double U, double V)? near)
    {
        if (!p.IsFinite || !(tolerance > 0))
        {
            throw new GeometryException(GeometryError.NotFinite, "the point to be projected has a coordinate that is no finite number, or the tolerance is not positive");
        }

        return SurfaceSearch.Run(this, Cells, p, tolerance, near);
    }
}
