using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The cuts of a run on one program, for many questions about the nearest place.</summary>
internal sealed class RunPath
{
    private readonly Cut[] _cuts;
    private readonly RigidTransform2 _moved;

    /// <summary>Reads the cuts.</summary>
    /// <param name="path">The program.</param>
    /// <param name="first">First motion of the run.</param>
    /// <param name="last">Last motion of the run.</param>
    public RunPath(NcPath path, int first, int last)
    {
        var cuts = new List<Cut>(last - first + 1);
        for (var i = first; i <= last; i++)
        {
            var motion = path.Motions[i];
            if (motion.MovesInPlane)
            {
                cuts.Add(new(i, motion.Segment, motion.IsArc ? motion.Arc : null, motion.PlaneLength));
            }
        }

        _cuts = [.. cuts];
    }

    private RunPath(Cut[] cuts, RigidTransform2 moved) => (_cuts, _moved) = (cuts, moved);

    /// <summary>The same cuts, moved.</summary>
    public RunPath Moved(RigidTransform2 by) => new(_cuts, by);

    /// <summary>The boundary that a tool leaves beside the programmed cuts of a run.</summary>
    /// <param name="center">The programmed path, compensated for the distance.</param>
    /// <param name="first">First motion of the run.</param>
    /// <param name="last">Last motion of the run.</param>
    /// <returns>Null if no cut of the run is there.</returns>
    public static RunPath? Beside(CompensatedPath center, int first, int last)
    {
        var cuts = new List<Cut>(last - first + 1);
        foreach (var motion in center.Motions)
        {
            if (motion.Motion >= first && motion.Motion <= last && motion.IsCompensated)
            {
                var segment = new Segment2(motion.Plane.Project(motion.Start), motion.Plane.Project(motion.End));
                Arc2? arc = motion.IsArc
                    ? Arc2.Between(segment.Start, segment.End, motion.Center, motion.Kind == MotionKind.ArcCounterClockwise)
                    : null;
                if (arc is not null || segment.Start != segment.End)
                {
                    cuts.Add(new(motion.Motion, segment, arc, arc?.Length ?? segment.Length));
                }
            }
        }

        return cuts.Count == 0 ? null : new([.. cuts], RigidTransform2.Identity);
    }

    /// <summary>The place that is nearest to a point, and how far it is.</summary>
    /// <param name="point">The point.</param>
    /// <param name="towardTool">Direction from the material to the tool there, for the sign.</param>
    public RunFoot FootOf(Point2 point, Vector2 towardTool)
    {
        if (_moved != RigidTransform2.Identity)
        {
            var back = _moved.Inverse();
            var foot = Nearest(back.Apply(point), back.Apply(towardTool));
            return foot with { Way = _moved.Apply(foot.Way) };
        }

        return Nearest(point, towardTool);
    }

    private RunFoot Nearest(Point2 point, Vector2 towardTool)
    {
        var (best, motion, fraction, way) = (double.PositiveInfinity, _cuts[0].Motion, 0.0, Vector2.Zero);
        foreach (ref readonly var cut in _cuts.AsSpan())
        {
            if (cut.Segment.Start.DistanceTo(point) - cut.Length >= best)
            {
                continue;
            }

            var f = cut.Arc is { } arc ? arc.NearestFraction(point) : cut.Segment.NearestFraction(point);
            var toPath = (cut.Arc is { } round ? round.At(f) : cut.Segment.At(f)) - point;
            if (toPath.Length < best)
            {
                (best, motion, fraction, way) = (toPath.Length, cut.Motion, f, toPath);
            }
        }

        return new(motion, fraction, way.Dot(towardTool) >= 0 ? best : -best, way);
    }

    private readonly record struct Cut(int Motion, Segment2 Segment, Arc2? Arc, double Length);
}

/// <summary>The place of a path that is nearest to a point.</summary>
/// <param name="Motion">Position of the motion in the path.</param>
/// <param name="Fraction">Place on it, 0 to 1.</param>
/// <param name="DistanceMm">The distance; positive if the path is on the tool's side of the point.</param>
/// <param name="Way">From the point to the place.</param>
internal sealed record RunFoot(int Motion, double Fraction, double DistanceMm, Vector2 Way);
