using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Where the center of the tool goes in XY under cutter compensation.</summary>
/// <param name="Motion">Position of the programmed motion in the path.</param>
/// <param name="Segment">Its way, or the ends of it.</param>
/// <param name="Arc">Its way if it is an arc.</param>
/// <param name="LowestMm">Its lowest height, mm.</param>
/// <param name="HighestMm">Its highest height, mm.</param>
internal sealed record CompensatedCenters(int Motion, Segment2 Segment, Arc2? Arc, double LowestMm, double HighestMm)
{
    /// <summary>The cuts of a program; none where the control would refuse it.</summary>
    /// <param name="path">The program, interpreted.</param>
    public static IEnumerable<CompensatedCenters> Of(NcPath path)
    {
        if (!CompensatedPath.Concerns(path) || CompensatedPath.Of(path) is not { Refusal: null } compensated)
        {
            yield break;
        }

        foreach (var motion in compensated.Motions)
        {
            var (start, end) = (motion.Plane.Project(motion.Start), motion.Plane.Project(motion.End));
            if (motion.IsCompensated && motion.Plane == CoordinatePlane.XY && (motion.IsArc || start != end)
                && motion.UnknownEnd == AxisSet.None)
            {
                yield return new(
                    motion.Motion,
                    new(start, end),
                    motion.IsArc ? Arc2.Between(start, end, motion.Center, motion.Kind == MotionKind.ArcCounterClockwise) : null,
                    Math.Min(motion.Start.Z, motion.End.Z),
                    Math.Max(motion.Start.Z, motion.End.Z));
            }
        }
    }
}
