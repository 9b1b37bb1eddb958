using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The cuts of a run on one program, for many questions about the nearest place.</summary>
internal sealed class RunPath
{
    private readonly Cut[] _cuts;

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

    /// <summary>The place that is nearest to a point, and how far it is.</summary>
    /// <param name="point">The point.</param>
    /// <param name="towardTool">Direction from the material to the tool there, for the sign.</param>
    public RunFoot FootOf(Point2 point, Vector2 towardTool)
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
internal readonly record struct RunFoot(int Motion, double Fraction, double DistanceMm, Vector2 Way);
