using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>An error fitted over (u, v) by one of the surface methods: the points (u, v, error) were fitted as points in space.</summary>
/// <param name="fit">The fitted surface: x is u, y is v, z the error in millimeters; u and v are scaled to lengths on the surface.</param>
/// <param name="scaleU">Millimeters per unit of u.</param>
/// <param name="scaleV">Millimeters per unit of v.</param>
/// <param name="standardUncertaintyMm">Standard uncertainty of the error.</param>
internal sealed class SurfaceHeightField(FittedSurface fit, double scaleU, double scaleV, double standardUncertaintyMm) : ErrorField
{
    private const int MostSteps = 50;

    public FittedSurface Fit => fit;

    public override double At(double u, double v)
    {
        // Newton's method for the place over (u, v). Fits hardly shift their parameters.
        var (x, y) = (u * scaleU, v * scaleV);
        var surface = fit.Surface;
        var (s, t) = (
            Within(surface.KnotsU, (x - X(0, 0)) / Nonzero(X(1, 0) - X(0, 0))),
            Within(surface.KnotsV, (y - Y(0, 0)) / Nonzero(Y(0, 1) - Y(0, 0))));
        var at = surface.At(s, t);
        for (var step = 0; step < MostSteps; step++)
        {
            var (f, g) = (at.Position.X - x, at.Position.Y - y);
            var determinant = (at.Du.X * at.Dv.Y) - (at.Dv.X * at.Du.Y);
            if (determinant == 0)
            {
                break;
            }

            var (ds, dt) = (((at.Dv.X * g) - (at.Dv.Y * f)) / determinant, ((at.Du.Y * f) - (at.Du.X * g)) / determinant);
            (s, t) = (s + ds, t + dt);
            at = surface.At(s, t);
            if (Math.Abs(ds) + Math.Abs(dt) < 1e-12)
            {
                break;
            }
        }

        return at.Position.Z;
    }

    public override double StandardUncertaintyAt(double u, double v) => standardUncertaintyMm;

    private double X(int endU, int endV) => Corner(endU, endV).X;

    private double Y(int endU, int endV) => Corner(endU, endV).Y;

    private Point3 Corner(int endU, int endV)
    {
        var surface = fit.Surface;
        return surface.PointAt(
            endU == 0 ? surface.KnotsU.Start : surface.KnotsU.End, endV == 0 ? surface.KnotsV.Start : surface.KnotsV.End);
    }

    private static double Nonzero(double x) => x == 0 ? 1 : x;

    private static double Within(KnotVector knots, double share) => knots.Start + ((knots.End - knots.Start) * Math.Clamp(share, 0, 1));
}
