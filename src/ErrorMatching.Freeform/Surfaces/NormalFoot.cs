using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Finds the place of a surface whose normal passes through a nearby point.</summary>
internal static class NormalFoot
{
    private const int Iterations = 50;

    /// <summary>Accuracy of the foot along the surface, mm. The effect on a ball's contact is smaller by the curvature.</summary>
    private const double AccuracyMm = 1e-10;

    /// <summary>Returns the foot by Newton's method from a nearby place (The NURBS Book, section 6.1); null if it does not converge. The
    /// surface is continued beyond its ends.</summary>
    public static SurfacePoint? Find(SplineSurface surface, Point3 point, double u, double v)
    {
        for (var i = 0; i < Iterations; i++)
        {
            var at = surface.At(u, v);
            var off = at.Position - point;
            var (f, g) = (off.Dot(at.Du), off.Dot(at.Dv));
            var (a, b, c) = (at.Du.Dot(at.Du) + off.Dot(at.Duu), at.Du.Dot(at.Dv) + off.Dot(at.Duv), at.Dv.Dot(at.Dv) + off.Dot(at.Dvv));
            var determinant = (a * c) - (b * b);

            // Beyond the center of curvature, the full Newton step diverges. The first fundamental form alone still converges.
            if (!(determinant > 0) || !(a > 0))
            {
                (a, b, c) = (at.Du.Dot(at.Du), at.Du.Dot(at.Dv), at.Dv.Dot(at.Dv));
                determinant = (a * c) - (b * b);
            }

            var (du, dv) = (((b * g) - (c * f)) / determinant, ((b * f) - (a * g)) / determinant);
            (u, v) = (u + du, v + dv);
            if (!double.IsFinite(u) || !double.IsFinite(v))
            {
                return null;
            }

            if (((at.Du * du) + (at.Dv * dv)).Length <= AccuracyMm)
            {
                return surface.At(u, v);
            }
        }

        return null;
    }
}
