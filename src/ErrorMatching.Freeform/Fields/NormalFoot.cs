using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The place on a surface whose normal goes through a point, searched from a place nearby.</summary>
/// <remarks>
/// Newton's method on the two conditions (S - P) . Su = 0 and (S - P) . Sv = 0 (Piegl and Tiller, The NURBS Book, section 6.1). At the rim the surface is continued, so that a point that was touched a little beside it has a foot too.
/// </remarks>
internal static class NormalFoot
{
    private const int MostSteps = 30;

    // Far below what any probe tells, far above what the arithmetic loses.
    private const double ToleranceMm = 1e-10;

    /// <summary>The foot, or null if the search leads nowhere: the point is too far from the surface for its curvature.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="point">The point in millimetres.</param>
    /// <param name="u">Where to start.</param>
    /// <param name="v">Where to start.</param>
    public static SurfacePoint? From(SplineSurface surface, Point3 point, double u, double v)
    {
        for (var step = 0; step < MostSteps; step++)
        {
            var at = surface.At(u, v);
            var away = at.Position - point;
            var (f, g) = (away.Dot(at.Du), away.Dot(at.Dv));
            var (a, b, c) = (at.Du.Dot(at.Du) + away.Dot(at.Duu), at.Du.Dot(at.Dv) + away.Dot(at.Duv), at.Dv.Dot(at.Dv) + away.Dot(at.Dvv));
            var determinant = (a * c) - (b * b);
            if (!(determinant > 0))
            {
                return null;
            }

            var (du, dv) = (((b * g) - (c * f)) / determinant, ((b * f) - (a * g)) / determinant);
            (u, v) = (u + du, v + dv);
            if (!double.IsFinite(u) || !double.IsFinite(v))
            {
                return null;
            }

            if (((at.Du * du) + (at.Dv * dv)).Length < ToleranceMm)
            {
                return surface.At(u, v);
            }
        }

        return null;
    }
}
