using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The actual effect of the new program at the key points, measured on its motions.</summary>
internal static class BoundaryShift
{
    private const int Iterations = 6;

    /// <summary>Displacement of the boundary at a key point along the normal from the counterpart's material to its tool: the distance to
    /// go along it until the new path is as far away as the old one was from the point. Secant method; the distance falls by nearly the
    /// length of each step.</summary>
    public static double NormalMm(
        JobCounterpart counterpart, NcPath before, NcPath after, FeaturePass pass, KeyPointFoot foot, Point2 theoretical)
    {
        var point = counterpart.Frame.Apply(theoretical);
        var wanted = Distance(before, pass, foot, point);
        var (last, lastOff) = (0.0, Distance(after, pass, foot, point) - wanted);
        var at = lastOff;
        for (var i = 0; i < Iterations && Math.Abs(at - last) > 1e-9; i++)
        {
            var off = Distance(after, pass, foot, point + (foot.Normal * at)) - wanted;
            var slope = (off - lastOff) / (at - last);
            (last, lastOff) = (at, off);
            at -= off / (Math.Abs(slope) > 0.1 ? slope : -1);
        }

        return at;
    }

    // Signed: positive if the path is on the tool's side of the point, as it is without cutter compensation.
    private static double Distance(NcPath path, FeaturePass pass, KeyPointFoot foot, Point2 point)
    {
        var nearest = double.PositiveInfinity;
        var signed = 0.0;
        for (var i = pass.First; i <= pass.Last; i++)
        {
            var motion = path.Motions[i];
            var fraction = motion.IsArc ? motion.Arc.NearestFraction(point) : motion.Segment.NearestFraction(point);
            var toPath = motion.PlaneAt(fraction) - point;
            if (toPath.Length < nearest)
            {
                nearest = toPath.Length;
                signed = toPath.Dot(foot.Normal) >= 0 ? nearest : -nearest;
            }
        }

        return signed;
    }
}
