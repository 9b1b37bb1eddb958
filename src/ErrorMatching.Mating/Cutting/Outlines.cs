using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Boundaries as polylines in the part's frame, for drawing.</summary>
internal static class Outlines
{
    private const int PointsOfAnArc = 24;

    /// <summary>The boundary along a pass: the path offset by the tool radius, or the path itself under cutter compensation.</summary>
    public static IReadOnlyList<Point2> Boundary(JobCounterpart counterpart, NcPath path, FeaturePass pass) =>
        Boundary(counterpart, path, pass, _ => 0, RigidTransform2.Identity);

    /// <summary>That boundary, moved toward the tool by a distance that depends on the length along the pass.</summary>
    public static IReadOnlyList<Point2> Boundary(
        JobCounterpart counterpart, NcPath path, FeaturePass pass, Func<double, double> towardTool) =>
        Boundary(counterpart, path, pass, towardTool, RigidTransform2.Identity);

    /// <summary>That boundary, then moved in the program's frame.</summary>
    public static IReadOnlyList<Point2> Boundary(
        JobCounterpart counterpart, NcPath path, FeaturePass pass, Func<double, double> towardTool, RigidTransform2 move)
    {
        var toPart = counterpart.Frame.Inverse();
        var points = new List<Point2>();
        for (var i = pass.First; i <= pass.Last; i++)
        {
            var motion = path.Motions[i];
            if (motion.PlaneLength < 1e-9)
            {
                continue;
            }

            var radius = motion.Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight) ? 0 : counterpart.ToolDiameterMm / 2;
            var (from, to) = (pass.Starts[i - pass.First], pass.Starts[i - pass.First + 1]);
            var steps = motion.IsArc ? PointsOfAnArc : 1;
            for (var step = 0; step <= steps; step++)
            {
                var fraction = (double)step / steps;
                var towardMaterial = pass.Feet[0].MaterialIsLeft ? motion.TangentAt(fraction).Left : -motion.TangentAt(fraction).Left;
                var place = motion.PlaneAt(fraction) + (towardMaterial * (radius - towardTool(from + ((to - from) * fraction))));
                points.Add(toPart.Apply(move.Apply(place)));
            }
        }

        return points;
    }
}
