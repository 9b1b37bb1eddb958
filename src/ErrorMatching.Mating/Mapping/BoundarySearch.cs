using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>
/// Finds the motions of a program that cut boundaries of which the key points are known: a proposal for a person to look at, never more. Of all uninterrupted cuts that pass the points of a boundary at one distance, all on one side,
/// it takes the nearest ones; from the first to the last point, and on as far as the boundary goes on straight or bends gently, at most by the distance of the two outermost points.
/// </summary>
/// <remarks>The cost is that of motions times points.</remarks>
public static class BoundarySearch
{
    /// <summary>Cosine of 30 degrees: a boundary bends less from one block to the next where no key point is.</summary>
    public const double BendCosine = 0.866;

    // Passes of one path at several depths: nearer to each other than an NC word can say.
    private const double SamePassMm = 0.0005;

    /// <summary>Seeks boundaries.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="boundaries">The boundaries.</param>
    /// <param name="toolDiameterMm">Diameter of the tool; null if it is not known yet: then any distance will do that is the same for all points.</param>
    /// <param name="mapMm">How far a key point may lie from where it belongs (<see cref="JobCounterpart.MapMm"/>).</param>
    /// <returns>For each of the boundaries, in their order, the passes that cut it in the order of the program; none where it was not found, and where its blocks could not be told from another one's.</returns>
    public static IReadOnlyList<IReadOnlyList<FoundPass>> Find(NcPath path, IReadOnlyList<SoughtBoundary> boundaries, double? toolDiameterMm, double mapMm)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(boundaries);
        var cuts = boundaries.Select(b => b.Plane).Distinct().ToDictionary(p => p, p => Cuts(path, p));
        var found = boundaries.Select(b => Cores(path, cuts[b.Plane], b.Points, toolDiameterMm / 2, mapMm)).ToArray();

        // What leads past the key points of one boundary is no continuation of another one.
        var taken = found.SelectMany(f => f.Select(c => c.Core)).ToList();
        for (var b = 0; b < found.Length; b++)
        {
            for (var k = 0; k < found[b].Count; k++)
            {
                var core = found[b][k];
                taken.Remove(core.Core);
                found[b][k] = core with { Core = Extended(path, core, taken) };
                taken.Add(found[b][k].Core);
            }
        }

        return [.. found.Select((f, b) => f.Exists(c => found.Where((_, o) => o != b).Any(o => o.Exists(d => Overlap(path, c.Core, d.Core)))) ? [] : (IReadOnlyList<FoundPass>)[.. f.Select(c => c.Core)])];
    }

    // What is cut in a plane without a break: nothing but motions without length between two that cut.
    private static List<FoundPass> Cuts(NcPath path, CoordinatePlane plane)
    {
        var cuts = new List<FoundPass>();
        var (first, last) = (-1, -1);
        for (var m = 0; m < path.Motions.Length; m++)
        {
            var motion = path.Motions[m];
            if (motion is { IsCut: true, MovesInPlane: true, IsKnownInPlane: true } && motion.Plane == plane && !motion.Has(MotionFlags.Expression | MotionFlags.Transformed | MotionFlags.BadArc))
            {
                (first, last) = (first < 0 ? m : first, m);
            }
            else if (first >= 0 && !(motion.IsCut && motion.End == motion.Start))
            {
                cuts.Add(new(first, last));
                first = -1;
            }
        }

        return first < 0 ? cuts : [.. cuts, new(first, last)];
    }

    private static List<Pass> Cores(NcPath path, List<FoundPass> cuts, IReadOnlyList<Point2> points, double? radius, double mapMm)
    {
        var cores = points.Count < 2 ? [] : cuts.Select(c => Core(path, c, points, radius, mapMm)).OfType<Pass>().ToList();
        var nearest = cores.Count == 0 ? 0 : cores.Min(c => c.DistanceMm);
        return cores.FindAll(c => c.DistanceMm <= nearest + SamePassMm);
    }

    private static Pass? Core(NcPath path, FoundPass cut, IReadOnlyList<Point2> points, double? radius, double mapMm)
    {
        var feet = points.Select(p => SoughtFoot.Of(path, cut, p)).ToArray();
        var compensated = feet[0].IsCompensated;
        var (least, most) = (feet.Min(f => f.DistanceMm), feet.Max(f => f.DistanceMm));
        var wanted = compensated ? 0 : radius ?? (least + most) / 2;
        if (most - wanted > mapMm || wanted - least > mapMm || feet.Any(f => f.IsTwice || f.IsCompensated != compensated || (!compensated && f.IsLeft != feet[0].IsLeft)))
        {
            return null;
        }

        // Where an end of the boundary is a corner of the path, the motion within it counts.
        var (ahead, back) = ((First: feet[0].Last, Last: feet[^1].First), (First: feet[^1].Last, Last: feet[0].First));
        var (first, last) = ahead.First <= ahead.Last ? ahead : back;
        if (first > last || feet.Any(f => f.Last < first || f.First > last))
        {
            return null;
        }

        Point2[] ordered = [.. ahead.First <= ahead.Last ? points : points.Reverse()];
        return new(cut, new(first, last), feet.Average(f => radius is { } r && !compensated ? Math.Abs(f.DistanceMm - r) : f.DistanceMm), ordered[..2], [ordered[^1], ordered[^2]]);
    }

    private static FoundPass Extended(NcPath path, Pass pass, List<FoundPass> taken)
    {
        var first = Reach(path, pass, pass.Begin, -1, m => m < pass.Cut.First || taken.Exists(t => m >= t.First && m <= t.Last));
        var last = Reach(path, pass, pass.End, 1, m => m > pass.Cut.Last || taken.Exists(t => m >= t.First && m <= t.Last));
        return new(first, last);
    }

    // The last motion, in a direction, that the boundary goes on along without a bend.
    private static int Reach(NcPath path, Pass pass, IReadOnlyList<Point2> outermost, int step, Func<int, bool> isForeign)
    {
        var at = step > 0 ? pass.Core.Last : pass.Core.First;
        var end = path.Motions[at];
        var fraction = end.IsArc ? end.Arc.NearestFraction(outermost[0]) : end.Segment.NearestFraction(outermost[0]);
        var room = outermost[0].DistanceTo(outermost[1]) - (end.PlaneLength * (step > 0 ? 1 - fraction : fraction));
        for (var m = at + step; !isForeign(m); m += step)
        {
            var motion = path.Motions[m];
            if (!motion.MovesInPlane)
            {
                continue;
            }

            room -= motion.PlaneLength;
            var (before, behind) = step > 0 ? (path.Motions[at], motion) : (motion, path.Motions[at]);
            if (room < 0 || before.TangentAt(1).Dot(behind.TangentAt(0)) < BendCosine)
            {
                break;
            }

            at = m;
        }

        return at;
    }

    private static bool Overlap(NcPath path, FoundPass one, FoundPass other) =>
        path.Motions[one.First].Block <= path.Motions[other.Last].Block && path.Motions[other.First].Block <= path.Motions[one.Last].Block;

    /// <summary>A pass: the cut that it is of, what leads past all key points, how near, and the two outermost points at both ends.</summary>
    private sealed record Pass(FoundPass Cut, FoundPass Core, double DistanceMm, IReadOnlyList<Point2> Begin, IReadOnlyList<Point2> End);
}
