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
    /// <summary>Code of the refusal of a boundary that no cut passes.</summary>
    public const string NotFound = "boundary-not-found";

    /// <summary>Code of the refusal of a boundary that a cut passes twice without a break.</summary>
    public const string CutTwice = "boundary-cut-twice";

    /// <summary>Cosine of 30 degrees: a boundary bends less from one block to the next where no key point is.</summary>
    public const double BendCosine = 0.866;

    // Passes of one path at several depths: nearer to each other than an NC word can say.
    private const double SamePassMm = 0.0005;

    /// <summary>Seeks boundaries.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="boundaries">The boundaries.</param>
    /// <param name="toolDiameterMm">Diameter of the tool; null if it is not known yet: then any distance will do that is the same for all points.</param>
    /// <param name="mapMm">How far a key point may lie from where it belongs (<see cref="JobCounterpart.MapMm"/>).</param>
    /// <returns>For each of the boundaries, in their order, the passes that cut it in the order of the program; none, and the reason, where it was not found, and where its blocks could not be told from another one's.</returns>
    public static IReadOnlyList<FoundBoundary> Find(NcPath path, IReadOnlyList<SoughtBoundary> boundaries, double? toolDiameterMm, double mapMm)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(boundaries);
        var cuts = boundaries.Select(b => b.Plane).Distinct().ToDictionary(p => p, p => Cuts(path, p));
        var (found, refusals) = (new List<Pass>[boundaries.Count], new MatingRefusal?[boundaries.Count]);
        for (var b = 0; b < found.Length; b++)
        {
            (found[b], refusals[b]) = Cores(path, cuts[boundaries[b].Plane], boundaries[b], toolDiameterMm / 2, mapMm);
        }

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

        return [.. found.Select((f, b) => (refusals[b] ?? Shared(path, boundaries, found, b)) is { } refusal ? new FoundBoundary([], refusal) : new FoundBoundary([.. f.Select(c => c.Core)]))];
    }

    /// <summary>A refusal at the block of a motion, which ends with what always helps.</summary>
    internal static MatingRefusal Refuse(NcPath path, int motion, string code, string message, string feature, string? point = null)
    {
        var block = path.Program[path.Motions[motion].Block];
        return new(code, $"{feature}, {path.Program.NameOf(block)}: {message}, or name the blocks yourself.", feature, point, path.Program.NameOf(block), block.Line);
    }

    // Why the blocks of a boundary cannot be told from another one's, or null.
    private static MatingRefusal? Shared(NcPath path, IReadOnlyList<SoughtBoundary> boundaries, List<Pass>[] found, int boundary)
    {
        foreach (var (core, other) in found[boundary].SelectMany(c => Enumerable.Range(0, found.Length).Where(o => o != boundary).Select(o => (c.Core, o))))
        {
            if (found[other].Exists(d => Overlap(path, core, d.Core)))
            {
                return Refuse(path, core.First, FeatureMapper.BlocksOverlap, $"from here on it leads past the points of {boundaries[boundary].Name} and of {boundaries[other].Name}, so it cannot be told whose blocks these are. Check the points of both", boundaries[boundary].Name);
            }
        }

        return null;
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

    // The nearest of all cuts that pass the boundary; or why the one that comes nearest to that does not.
    private static (List<Pass> Cores, MatingRefusal? Refusal) Cores(NcPath path, List<FoundPass> cuts, SoughtBoundary boundary, double? radius, double mapMm)
    {
        if (boundary.Points.Count < 2)
        {
            return ([], new(NotFound, $"{boundary.Name}: fewer than two of its points have a place in the program. Give them their coordinates, or name the blocks yourself.", boundary.Name));
        }

        var fits = cuts.ConvertAll(c => CutFit.Of(path, c, boundary.Points, radius, mapMm));
        var cores = fits.FindAll(f => f.Fault == CutFault.None).ConvertAll(f => Core(f, boundary, radius));
        if (cores.Count == 0)
        {
            return ([], fits.MinBy(f => f.MissMm)?.Refuse(path, boundary, radius, mapMm)
                ?? new MatingRefusal(NotFound, $"{boundary.Name}: the program cuts nothing in the plane {boundary.Plane} of which it says where. Check the program and the plane.", boundary.Name));
        }

        var nearest = cores.Min(c => c.DistanceMm);
        return (cores.FindAll(c => c.DistanceMm <= nearest + SamePassMm), null);
    }

    private static Pass Core(CutFit fit, SoughtBoundary boundary, double? radius)
    {
        Point2[] ordered = [.. (fit.IsAgainst ? boundary.Points.Reverse() : boundary.Points).Select(p => p.At)];
        return new(fit.Cut, fit.Core, fit.Feet.Average(f => radius is { } r && !f.IsCompensated ? Math.Abs(f.DistanceMm - r) : f.DistanceMm), ordered[..2], [ordered[^1], ordered[^2]]);
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
