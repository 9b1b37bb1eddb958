using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Between a surface and its parameters: what is needed to bring curves in space to (u, v).</summary>
/// <param name="PointAt">The point at a pair of parameters, in millimetres.</param>
/// <param name="FootOf">The parameters of the place closest to a point; the second argument is a place near it, where one is known, so that a path stays on its side of a seam.</param>
internal sealed record SurfaceMap(Func<Point2, Point3> PointAt, Func<Point3, Point2?, Point2> FootOf)
{
    private const double FootToleranceMm = 1e-6;

    /// <summary>The parameters of a B-spline surface.</summary>
    public static SurfaceMap Of(SplineSurface surface) => new(
        q => surface.PointAt(q.X, q.Y),
        (p, near) =>
        {
            var foot = near is { } n ? surface.ClosestPoint(p, n.X, n.Y, FootToleranceMm) : surface.ClosestPoint(p, FootToleranceMm);
            return new(foot.At.U, foot.At.V);
        });
}
