using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Distances of points from a surface along its normals.</summary>
/// <remarks>The surface is continued slightly beyond its edges, so that the distance of a point just beyond an edge does not include the
/// offset along the surface.</remarks>
public sealed class SurfaceDistance
{
    private const int SamplesPerPiece = 3;

    /// <summary>How far a foot may be beyond an edge, as a share of the parameters.</summary>
    private const double Beyond = 0.05;

    private readonly SplineSurface _surface;
    private readonly Lazy<(double[] Us, double[] Vs, Point3[] Points)> _samples;

    /// <summary>Prepares distances from a surface.</summary>
    public SurfaceDistance(SplineSurface surface)
    {
        ArgumentNullException.ThrowIfNull(surface);
        _surface = surface;
        _samples = new(() =>
        {
            var (us, vs) = (Places(surface.KnotsU), Places(surface.KnotsV));
            return (us, vs, surface.PointsAt(us, vs));
        });
    }

    /// <summary>Signed distance of a point from its foot on the surface, in millimeters, positive towards the normal Du x Dv.</summary>
    public double To(Point3 point)
    {
        var (u, v) = Nearest(point);
        return To(point, u, v);
    }

    /// <summary>The same, starting from parameters near the foot.</summary>
    internal double To(Point3 point, double u, double v)
    {
        var at = Foot(point, u, v);
        return (point - at.Position).Dot(at.Normal);
    }

    /// <summary>Mean and largest absolute distance of points, in millimeters.</summary>
    /// <param name="points">At least one.</param>
    public DistanceSummary Of(IEnumerable<Point3> points)
    {
        var (sum, largest, count) = (0.0, 0.0, 0);
        foreach (var point in points)
        {
            var distance = Math.Abs(To(point));
            (sum, largest, count) = (sum + distance, Math.Max(largest, distance), count + 1);
        }

        return new(sum / count, largest);
    }

    private static double[] Places(KnotVector knots)
    {
        var breaks = knots.Breaks;
        return [.. Enumerable.Range(0, ((breaks.Count - 1) * SamplesPerPiece) + 1).Select(k => k % SamplesPerPiece == 0
            ? breaks[k / SamplesPerPiece]
            : breaks[k / SamplesPerPiece]
                + ((breaks[(k / SamplesPerPiece) + 1] - breaks[k / SamplesPerPiece]) * (k % SamplesPerPiece) / SamplesPerPiece))];
    }

    /// <summary>The place whose normal passes through the point. If there is none nearby, or only far beyond an edge, the
    /// nearest place.</summary>
    private SurfacePoint Foot(Point3 point, double u, double v)
    {
        if (NormalFoot.Find(_surface, point, u, v) is { } foot && IsWithin(_surface.KnotsU, foot.U) && IsWithin(_surface.KnotsV, foot.V))
        {
            return foot;
        }

        return _surface.ClosestPoint(point).At;
    }

    private static bool IsWithin(KnotVector knots, double t)
    {
        var margin = Beyond * (knots.End - knots.Start);
        return t >= knots.Start - margin && t <= knots.End + margin;
    }

    /// <summary>The nearest of samples spread over the surface.</summary>
    private (double U, double V) Nearest(Point3 point)
    {
        var (us, vs, samples) = _samples.Value;
        var (best, least) = (0, double.PositiveInfinity);
        for (var k = 0; k < samples.Length; k++)
        {
            var d = samples[k] - point;
            var square = d.Dot(d);
            if (square < least)
            {
                (best, least) = (k, square);
            }
        }

        return (us[best / vs.Length], vs[best % vs.Length]);
    }
}

/// <summary>Distances of points from a surface along its normals.</summary>
/// <param name="MeanMm">Mean absolute distance in millimeters.</param>
/// <param name="MaxMm">Largest absolute distance in millimeters.</param>
public readonly record struct DistanceSummary(double MeanMm, double MaxMm);
