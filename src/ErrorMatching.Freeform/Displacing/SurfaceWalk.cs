using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Finds the feet of consecutive ball centers, usually near the previous foot.</summary>
internal sealed class SurfaceWalk(PartSurface surface, ErrorField field, double gain, double radiusMm, bool programsTip)
{
    // Share of the parameter range by which a foot may exceed the edge and still be on it.
    private const double OnEdge = 1e-9;

    private readonly Box3 _box = surface.Spline.Box();
    private (double U, double V)? _last;

    public SurfaceContact At(Point3 programmed)
    {
        var center = CenterOf(programmed);
        var away = _box.DistanceTo(center);
        if (away > (2 * radiusMm) + 1)
        {
            return new(away - radiusMm, Vector3.Zero);
        }

        var foot = Foot(center);
        var normal = surface.NormalOf(foot);
        var offset = center - foot.Position;
        var height = offset.Dot(normal);

        // A center below the surface but beyond an edge cuts nothing.
        var over = height >= 0 || (offset - (normal * height)).Length < 1e-6
            ? (height < 0 ? -offset.Length : offset.Length) - radiusMm
            : offset.Length - radiusMm;
        return new(over, normal * (-gain * field.At(foot.U, foot.V)));
    }

    /// <summary>True if the surface is not trimmed away under a ball.</summary>
    public bool IsOverPart(Point3 programmed)
    {
        var foot = surface.Spline.ClosestPoint(CenterOf(programmed)).At;
        return surface.Region.Contains(foot.U, foot.V);
    }

    private Point3 CenterOf(Point3 programmed) => programsTip ? programmed + new Vector3(0, 0, radiusMm) : programmed;

    // Newton's method from the previous foot finds the nearest place if the surface is not hollower than the ball and the point is near.
    private SurfacePoint Foot(Point3 center)
    {
        var (u, v) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
        if (_last is { } near
            && NormalFoot.Find(surface.Spline, center, near.U, near.V) is { } found
            && Inside(found.U, u)
            && Inside(found.V, v)
            && (center - found.Position).Length <= 2 * radiusMm && (center - found.Position).Dot(surface.NormalOf(found)) > 0)
        {
            _last = (found.U, found.V);
            return found;
        }

        var foot = surface.Spline.ClosestPoint(center).At;
        _last = (foot.U, foot.V);
        return foot;
    }

    private static bool Inside(double t, KnotVector knots) =>
        t >= knots.Start - (OnEdge * (knots.End - knots.Start)) && t <= knots.End + (OnEdge * (knots.End - knots.Start));
}
