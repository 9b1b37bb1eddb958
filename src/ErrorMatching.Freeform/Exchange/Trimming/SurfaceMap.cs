using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Maps between a surface and its parameters, to bring curves in space to (u, v).</summary>
/// <param name="PointAt">The point at a pair of parameters, in millimeters.</param>
/// <param name="FootOf">The parameters of the place closest to a point. The second argument is a place near it, if known, so that a path
/// stays on its side of a seam.</param>
/// <param name="Seam">Where a surface with the file's own parameters closes on itself. Other parameters continue beyond a turn.</param>
internal sealed record SurfaceMap(Func<Point2, Point3> PointAt, Func<Point3, Point2?, Point2> FootOf, SurfaceSeam Seam = default)
{
    private const double FootToleranceMm = 1e-6;

    /// <summary>The map of a B-spline surface. If the surface is closed, parameters continue from the previous place, so that a path may
    /// reach or cross the seam.</summary>
    public static SurfaceMap Of(SplineSurface surface)
    {
        var seam = SurfaceSeam.Find(surface);
        return new(
            q =>
            {
                var at = seam.Within(surface, q);
                return surface.PointAt(at.X, at.Y);
            },
            (p, near) =>
            {
                if (near is not { } n)
                {
                    var first = surface.ClosestPoint(p, FootToleranceMm);
                    return new(first.At.U, first.At.V);
                }

                var start = seam.Within(surface, n);
                var foot = surface.ClosestPoint(p, start.X, start.Y, FootToleranceMm);
                return seam.Beside(new(foot.At.U, foot.At.V), n);
            },
            seam);
    }
}
