using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>A cylinder, converted to a rational B-spline of the size of its boundary. Until then, its parameters are the angle in radians
/// and the height in millimeters.</summary>
/// <param name="Origin">The point of the axis at height 0.</param>
/// <param name="X">Unit vector from the axis to angle 0.</param>
/// <param name="Y">Unit vector from the axis to a quarter turn.</param>
/// <param name="Axis">Unit vector along the axis.</param>
/// <param name="Radius">In millimeters.</param>
internal sealed record CylinderPatch(Point3 Origin, Vector3 X, Vector3 Y, Vector3 Axis, double Radius)
{
    /// <summary>Its parameter map. Angles continue from the previous place, so that a path may cross angle 0.</summary>
    public SurfaceMap Map => new(At, (p, near) =>
    {
        var d = p - Origin;
        var angle = Elementary.Atan2(d.Dot(Y), d.Dot(X));
        return new(near is { } n ? angle + (Math.Tau * Math.Round((n.X - angle) / Math.Tau)) : angle, d.Dot(Axis));
    });

    /// <summary>Returns the part inside polygons of angle and height.</summary>
    public (SplineSurface Spline, SurfaceRegion Region) Inside(
        IReadOnlyList<IReadOnlyList<Point2>> loops, Func<string, string, InputException> fail)
    {
        // Each loop started at its own angle. Holes are shifted by whole turns to the largest loop.
        var outer = loops.MaxBy(l => Math.Abs(RegionLoop.Area(l))) ?? [];
        var (first, last) = RegionLoop.Bounds([outer], fail);
        var middle = (first.X + last.X) / 2;
        var together = loops.Select(l => Turned(l, middle)).ToList();
        var (least, most) = RegionLoop.Bounds(together, fail);
        if (most.X - least.X > Math.Tau * (1 + 1e-9))
        {
            throw fail("bad-loop", "the limits of a cylinder go round it more than once");
        }

        var arc = SplineArc.Of(new(Origin.X, Origin.Y, Origin.Z), X * Radius, Y * Radius, least.X, most.X);
        var poles = new List<Point3>();
        var weights = new List<double>();
        for (var i = 0; i < arc.Poles.Length; i++)
        {
            poles.AddRange([arc.Poles[i] + (Axis * least.Y), arc.Poles[i] + (Axis * most.Y)]);
            weights.AddRange([arc.Weights[i], arc.Weights[i]]);
        }

        var spline = new SplineSurface(arc.Knots, KnotVector.Clamped(1, [least.Y, most.Y]), poles.ToArray(), weights.ToArray());
        var mapped = together.Select(
            l => (IReadOnlyList<Point2>)[.. l.Select(q => new Point2(SplineArc.ParameterOf(q.X, least.X, most.X), q.Y))]).ToList();
        return (spline, RegionLimits.Of(spline, mapped, fail));
    }

    private static IReadOnlyList<Point2> Turned(IReadOnlyList<Point2> loop, double middle)
    {
        var own = (loop.Min(q => q.X) + loop.Max(q => q.X)) / 2;
        var turns = Math.Tau * Math.Round((middle - own) / Math.Tau);
        return turns == 0 ? loop : [.. loop.Select(q => new Point2(q.X + turns, q.Y))];
    }

    private Point3 At(Point2 q) => Origin + (X * (Radius * Elementary.Cos(q.X))) + (Y * (Radius * Elementary.Sin(q.X))) + (Axis * q.Y);
}
