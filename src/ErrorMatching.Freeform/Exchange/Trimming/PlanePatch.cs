using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>A plane, converted to a B-spline of the size of its boundary. Its parameters are millimeters along two axes.</summary>
/// <param name="Origin">The place where the parameters are 0.</param>
/// <param name="X">Unit vector along u.</param>
/// <param name="Y">Unit vector along v, perpendicular to <paramref name="X"/>.</param>
internal sealed record PlanePatch(Point3 Origin, Vector3 X, Vector3 Y)
{
    public SurfaceMap Map => new(At, (p, _) => new((p - Origin).Dot(X), (p - Origin).Dot(Y)));

    /// <summary>Returns the part inside polygons.</summary>
    public (SplineSurface Spline, SurfaceRegion Region) Inside(
        IReadOnlyList<IReadOnlyList<Point2>> loops, Func<string, string, InputException> fail)
    {
        var (least, most) = RegionLoop.Bounds(loops, fail);
        Point3[] poles = [At(least), At(new(least.X, most.Y)), At(new(most.X, least.Y)), At(most)];
        var spline = new SplineSurface(KnotVector.Clamped(1, [least.X, most.X]), KnotVector.Clamped(1, [least.Y, most.Y]), poles);
        return (spline, RegionLimits.Of(spline, loops, fail));
    }

    private Point3 At(Point2 q) => Origin + (X * q.X) + (Y * q.Y);
}
