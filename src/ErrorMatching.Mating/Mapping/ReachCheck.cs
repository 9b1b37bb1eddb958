using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Checks under cutter compensation that the tool touches each key point: in an inside corner it leaves a round of its own radius,
/// where the programmed contour is not cut. Without compensation the distance from the path shows that.</summary>
internal static class ReachCheck
{
    /// <summary>The key points that the tool does not touch; none if the path of its center is not known.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted with the job's tool.</param>
    /// <param name="maps">The places of the key points.</param>
    /// <param name="theoretical">The key points as designed.</param>
    public static IReadOnlyList<UnreachedPoint> Unreached(
        MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps, MeasurementFile theoretical)
    {
        var unreached = new List<UnreachedPoint>();
        if (!CompensatedPath.Concerns(path) || CompensatedPath.Of(path) is not { Refusal: null } center)
        {
            return unreached;
        }

        var radius = job.Counterpart.ToolDiameterMm / 2;
        foreach (var map in maps)
        {
            var pass = map.Passes[0];
            if (!path.Motions[pass.First].Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight))
            {
                continue;
            }

            foreach (var foot in pass.Feet)
            {
                var point = job.Counterpart.PlaceOf(theoretical[foot.Label], map.Feature.Plane, theoretical.File);
                var gap = Nearest(center, pass, point) - radius;
                if (gap > job.Counterpart.MapMm)
                {
                    unreached.Add(new(foot.Label, foot.Motion, gap));
                }
            }
        }

        return unreached;
    }

    private static double Nearest(CompensatedPath center, FeaturePass pass, Point2 point)
    {
        var nearest = double.PositiveInfinity;
        foreach (var motion in center.Motions)
        {
            if (motion.Motion >= pass.First && motion.Motion <= pass.Last + 1 && motion.IsCompensated)
            {
                nearest = Math.Min(nearest, Distance(motion, point));
            }
        }

        return nearest;
    }

    private static double Distance(in CompensatedMotion motion, Point2 point)
    {
        var (start, end) = (motion.Plane.Project(motion.Start), motion.Plane.Project(motion.End));
        return !motion.IsArc ? start == end ? start.DistanceTo(point) : new Segment2(start, end).DistanceTo(point)
            : Arc2.Between(start, end, motion.Center, motion.Kind == MotionKind.ArcCounterClockwise).DistanceTo(point);
    }
}

/// <summary>A key point that the tool does not touch.</summary>
/// <param name="Label">The point.</param>
/// <param name="Motion">The motion on which it lies.</param>
/// <param name="GapMm">Distance at which the tool passes it, mm.</param>
internal sealed record UnreachedPoint(string Label, int Motion, double GapMm);
