namespace ErrorMatching.Geometry;

/// <summary>Newton's method for the closest point of a surface, limited to the surface's parameter range.</summary>
internal static class SurfaceDescent
{
    private const int MaxSteps = 40;
    private const int MaxHalvings = 40;

    /// <summary>Descends from a pair of parameters to a minimum of the distance, to the last digits where the surface is smooth.</summary>
    public static SurfacePoint From(SplineSurface surface, Point3 p, double u, double v)
    {
        var (knotsU, knotsV) = (surface.KnotsU, surface.KnotsV);
        var (u0, u1, v0, v1) = (knotsU.Start, knotsU.End, knotsV.Start, knotsV.End);
        var at = surface.At(Math.Clamp(u, u0, u1), Math.Clamp(v, v0, v1));
        for (var step = 0; step < MaxSteps; step++)
        {
            var d = at.Position - p;
            var (du, dv) = Step(at, d, u0, u1, v0, v1);
            var length = (at.Du * du).Length + (at.Dv * dv).Length;
            var size = Math.Abs(at.Position.X) + Math.Abs(at.Position.Y) + Math.Abs(at.Position.Z) + d.Length;
            if (!(length > 4e-16 * size))
            {
                break;
            }

            // The distance is too flat at its minimum to judge so short a step, and Newton's step is more accurate.
            if (length < 1e-8 * size)
            {
                at = surface.At(Math.Clamp(at.U + du, u0, u1), Math.Clamp(at.V + dv, v0, v1));
                if (length < 1e-12 * size)
                {
                    break;
                }

                continue;
            }

            // If Newton's step is cut off at the limit of one parameter, it may lead up along the other. Steps against each slope never do.
            var lower = Lower(surface, p, at, du, dv)
                ?? (
                    IsCutOff(at.U + du, u0, u1) || IsCutOff(at.V + dv, v0, v1)
                        ? Lower(surface, p, at, Against(d, at.Du), Against(d, at.Dv))
                        : null);
            if (lower is null)
            {
                break;
            }

            at = lower.Value;
        }

        return at;
    }

    private static bool IsCutOff(double parameter, double least, double most) => parameter < least || parameter > most;

    private static double Against(Vector3 d, Vector3 along) => along.Dot(along) is > 0 and var square ? -d.Dot(along) / square : 0;

    private static SurfacePoint? Lower(SplineSurface surface, Point3 p, SurfacePoint at, double du, double dv)
    {
        var (knotsU, knotsV) = (surface.KnotsU, surface.KnotsV);
        var distance = (at.Position - p).Length;
        var share = 1.0;
        for (var i = 0; i < MaxHalvings; i++)
        {
            var next = surface.At(
                Math.Clamp(at.U + (share * du), knotsU.Start, knotsU.End), Math.Clamp(at.V + (share * dv), knotsV.Start, knotsV.End));
            if ((next.Position - p).Length < distance)
            {
                return next;
            }

            share *= 0.5;
        }

        return null;
    }

    /// <summary>A Newton step where the distance is convex, otherwise a Gauss-Newton step. A parameter at its limit is fixed if descent
    /// leads beyond.</summary>
    private static (double U, double V) Step(in SurfacePoint at, Vector3 d, double u0, double u1, double v0, double v1)
    {
        var (gu, gv) = (d.Dot(at.Du), d.Dot(at.Dv));
        var (e, f, g) = (at.Du.Dot(at.Du), at.Du.Dot(at.Dv), at.Dv.Dot(at.Dv));
        var (uu, uv, vv) = (e + d.Dot(at.Duu), f + d.Dot(at.Duv), g + d.Dot(at.Dvv));
        var (freeU, freeV) = (
            e > 0 && !(at.U <= u0 && gu > 0) && !(at.U >= u1 && gu < 0), g > 0 && !(at.V <= v0 && gv > 0) && !(at.V >= v1 && gv < 0));
        if (freeU && freeV)
        {
            var convex = uu > 0 && (uu * vv) - (uv * uv) > 1e-10 * uu * Math.Abs(vv);
            (uu, uv, vv) = convex ? (uu, uv, vv) : (e, f, g);
            var det = (uu * vv) - (uv * uv);
            if (det > 1e-12 * uu * vv)
            {
                var (du, dv) = (((uv * gv) - (vv * gu)) / det, ((uv * gu) - (uu * gv)) / det);

                // If a limit blocks one parameter of a common step, calculate the step again for the other.
                var (outU, outV) = (at.U <= u0 && du < 0 || at.U >= u1 && du > 0, at.V <= v0 && dv < 0 || at.V >= v1 && dv > 0);
                if (!outU && !outV)
                {
                    return (du, dv);
                }

                (freeU, freeV) = (!outU, !outV);
            }
            else
            {
                return (-gu / (2 * e), -gv / (2 * g));
            }
        }

        return (freeU ? -gu / (uu > 0 ? uu : e) : 0, freeV ? -gv / (vv > 0 ? vv : g) : 0);
    }
}
