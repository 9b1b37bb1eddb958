using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Finds the motions of a program that cut boundaries with known key points. The result is a proposal for the user to check.
/// Candidates are all uninterrupted cuts that pass a boundary's points at one distance, all on one side; the nearest ones are chosen. A
/// cut is taken from the first to the last point, and beyond them while the boundary continues straight or bends gently, at most by the
/// distance between the two outermost points.</summary>
/// <remarks>The cost is proportional to motions times points.</remarks>
public static class BoundarySearch
{
    /// <summary>Code of the refusal of a boundary that no cut passes.</summary>
    public const string NotFound = "boundary-not-found";

    /// <summary>Code of the refusal of a boundary that a cut passes twice without a break.</summary>
    public const string CutTwice = "boundary-cut-twice";

    /// <summary>Cosine of 30 degrees: away from key points, a boundary bends less than this from one block to the next.</summary>
    public const double BendCosine = 0.866;

    /// <summary>Code of the refusal of a straight boundary with a key point on a rounded corner; a match warns with the same
    /// code.</summary>
    public const string PointOnCorner = "point-on-corner";

    // Sine of 5.7 degrees. Up to it two lines are pieces of one, and an arc is tangent, as in the program rewriter.
    private const double StraightSine = 0.1;

    // Passes of one path at several depths: closer to each other than an NC word can express.
    private const double SamePassMm = 0.0005;

    /// <summary>Searches for boundaries.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="boundaries">The boundaries.</param>
    /// <param name="toolDiameterMm">Diameter of the tool; null if unknown. Then any distance that is the same for all points is
    /// accepted.</param>
    /// <param name="mapMm">Allowed distance of a key point from where it belongs (<see cref="JobCounterpart.MapMm"/>).</param>
    /// <returns>For each boundary, in order, the passes that cut it in the order of the program; or none, with the reason, if it was not
    /// found or its blocks cannot be distinguished from another boundary's.</returns>
    public static IReadOnlyList<FoundBoundary> Find(
        NcPath path, IReadOnlyList<SoughtBoundary> boundaries, double? toolDiameterMm, double mapMm)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(boundaries);
        var cuts = boundaries.Select(b => b.Plane).Distinct().ToDictionary(p => p, p => Cuts(path, p));
        var (found, refusals) = (new List<Pass>[boundaries.Count], new Refusal?[boundaries.Count]);
        for (var b = 0; b < found.Length; b++)
        {
            (found[b], refusals[b]) = Cores(path, cuts[boundaries[b].Plane], boundaries[b], toolDiameterMm / 2, mapMm);
        }

        // Motions along the key points of one boundary do not continue another.
        var taken = found.SelectMany(f => f.Select(c => c.Core)).ToList();
        for (var b = 0; b < found.Length; b++)
        {
            for (var k = 0; k < found[b].Count; k++)
            {
                var core = found[b][k];
                taken.Remove(core.Core);
                found[b][k] = core.IsWhole ? core : core with { Core = Extended(path, core, boundaries[b].IsStraight, taken) };
                taken.Add(found[b][k].Core);
            }
        }

        return [
            .. found.Select(
                (f, b) => (refusals[b] ?? Shared(path, boundaries, found, b)) is { } refusal
                    ? new FoundBoundary([], refusal)
                    : new FoundBoundary([.. f.Select(c => c.Core)]))];
    }

    /// <summary>Why a match would refuse the blocks found for a feature, checked by mapping the points as designed.</summary>
    /// <param name="job">The job; blocks that it names are ignored.</param>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <param name="feature">Index of the feature, from 0.</param>
    /// <param name="blocks">Selectors of the blocks.</param>
    /// <returns>The reason, or null if a match accepts them.</returns>
    /// <exception cref="InputException">A key point is missing, or has no coordinate in the feature's plane. A selector cannot be
    /// read.</exception>
    public static Refusal? Try(MatingJob job, NcPath path, MeasurementFile theoretical, int feature, IReadOnlyList<string> blocks)
    {
        ArgumentNullException.ThrowIfNull(job);
        return FeatureMapper.Map(job with { Features = [job.Features[feature] with { Blocks = blocks }] }, path, theoretical, out _);
    }

    /// <summary>A refusal at the block of a motion; it ends with a generally applicable remedy.</summary>
    internal static Refusal Refuse(NcPath path, int motion, string code, string message, string feature, string? point = null) =>
        FeatureRefusal.At(path, path.Motions[motion].Block, code, $"{message}, or name the blocks yourself.", feature, point);

    // Why a boundary's blocks cannot be distinguished from another boundary's, or null.
    private static Refusal? Shared(NcPath path, IReadOnlyList<SoughtBoundary> boundaries, List<Pass>[] found, int boundary)
    {
        foreach (var (core, other) in found[boundary].SelectMany(
            c => Enumerable.Range(0, found.Length).Where(o => o != boundary).Select(o => (c.Core, o))))
        {
            if (found[other].Exists(d => Overlap(path, core, d.Core)))
            {
                return Refuse(
                    path,
                    core.First,
                    FeatureMapper.BlocksOverlap,
                    $"from here on it leads past the points of {boundaries[boundary].Name} and of {boundaries[other].Name}, so it cannot "
                        + $"be told whose blocks these are. Check the points of both",
                    boundaries[boundary].Name);
            }
        }

        return null;
    }

    // Uninterrupted cuts in a plane: between two cutting motions there are only motions without length.
    private static List<FoundPass> Cuts(NcPath path, CoordinatePlane plane)
    {
        var cuts = new List<FoundPass>();
        var (first, last) = (-1, -1);
        for (var m = 0; m < path.Motions.Length; m++)
        {
            var motion = path.Motions[m];
            if (motion is { IsCut: true, MovesInPlane: true, IsKnownInPlane: true }
                && motion.Plane == plane
                && !motion.Has(MotionFlags.Transformed | MotionFlags.BadArc))
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

    // The nearest of all cuts that pass the boundary; or why the closest candidate does not.
    private static (List<Pass> Cores, Refusal? Refusal) Cores(
        NcPath path, List<FoundPass> cuts, SoughtBoundary boundary, double? radius, double mapMm)
    {
        if (boundary.Points.Count < 2)
        {
            return (
                [],
                new(
                    NotFound,
                    $"{boundary.Name}: fewer than two of its points have a place in the program. Give them their coordinates, or name "
                        + $"the blocks yourself.",
                    new() { Feature = boundary.Name }));
        }

        var fits = cuts.ConvertAll(c => CutFit.Fit(path, c, boundary, radius, mapMm));
        var cores = fits.FindAll(f => f.Fault == CutFault.None).ConvertAll(f => Core(f, boundary, radius));
        if (cores.Count == 0)
        {
            return ([], fits.MinBy(f => f.MissMm)?.Refuse(path, boundary, radius, mapMm)
                ?? new Refusal(
                    NotFound,
                    $"{boundary.Name}: the program cuts nothing in the plane {boundary.Plane} of which it says where. Check the program "
                        + $"and the plane.",
                    new() { Feature = boundary.Name }));
        }

        var nearest = cores.Min(c => c.DistanceMm);
        cores.RemoveAll(c => c.DistanceMm > nearest + SamePassMm);
        for (var i = 0; boundary.IsStraight && i < cores.Count; i++)
        {
            if (WithoutCorners(path, boundary, cores[i], mapMm, out var straight) is { } refusal)
            {
                return ([], refusal);
            }

            cores[i] = cores[i] with { Core = straight };
        }

        return (cores, null);
    }

    private static Pass Core(CutFit fit, SoughtBoundary boundary, double? radius)
    {
        Point2[] ordered = [.. (fit.IsAgainst ? boundary.Points.Reverse() : boundary.Points).Select(p => p.At)];
        var distance = fit.Feet.Average(f => radius is { } r && !f.IsCompensated ? Math.Abs(f.DistanceMm - r) : f.DistanceMm);
        return new(fit.Cut, fit.Core, fit.IsAgainst, fit.IsWhole, fit.WantedMm, distance, ordered[..2], [ordered[^1], ordered[^2]]);
    }

    // An arc that turns is not a piece of a straight boundary but a corner, which follows both adjacent elements. A point that is also
    // beside the element before the arc does not need the arc.
    private static Refusal? WithoutCorners(NcPath path, SoughtBoundary boundary, Pass pass, double mapMm, out FoundPass straight)
    {
        straight = pass.Core;
        foreach (var (step, isFirst) in new[] { (1, !pass.IsAgainst), (-1, pass.IsAgainst) })
        {
            var end = step > 0 ? straight.First : straight.Last;
            if (!path.Motions[end].IsArc || Math.Abs(path.Motions[end].Arc.Sweep.Radians) <= StraightSine)
            {
                continue;
            }

            var (label, at) = isFirst ? boundary.Points[0] : boundary.Points[^1];
            var inner = Next(path, end, step);
            if (inner < straight.First || inner > straight.Last || Math.Abs(DistanceMm(path.Motions[inner], at) - pass.WantedMm) > mapMm)
            {
                var why = $"the point {label} lies at this arc, a rounded corner, which follows both elements that meet there. "
                    + "Choose the point further from the corner";
                return Refuse(path, end, PointOnCorner, why, boundary.Name, label);
            }

            straight = step > 0 ? straight with { First = inner } : straight with { Last = inner };
        }

        return null;
    }

    private static double DistanceMm(in NcMotion motion, Point2 point) =>
        motion.PlaneAt(motion.IsArc ? motion.Arc.NearestFraction(point) : motion.Segment.NearestFraction(point)).DistanceTo(point);

    // The next motion in a direction that has a length in its plane; past the path's end if there is none.
    private static int Next(NcPath path, int motion, int step)
    {
        var next = motion + step;
        while (next >= 0 && next < path.Motions.Length && !path.Motions[next].MovesInPlane)
        {
            next += step;
        }

        return next;
    }

    private static FoundPass Extended(NcPath path, Pass pass, bool isStraight, List<FoundPass> taken)
    {
        var first = Reach(path, pass, pass.Begin, -1, isStraight, m => m < pass.Cut.First || IsTaken(m));
        var last = Reach(path, pass, pass.End, 1, isStraight, m => m > pass.Cut.Last || IsTaken(m));
        return new(first, last);

        bool IsTaken(int motion) => taken.Exists(t => motion >= t.First && motion <= t.Last);
    }

    // The last motion in a direction along which the boundary continues without a bend.
    private static int Reach(NcPath path, Pass pass, IReadOnlyList<Point2> outermost, int step, bool isStraight, Func<int, bool> isForeign)
    {
        var at = step > 0 ? pass.Core.Last : pass.Core.First;
        var end = path.Motions[at];
        var direction = end.TangentAt(step > 0 ? 1 : 0);
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
            var leaves = isStraight
                ? motion.IsArc || Math.Abs(direction.Cross(motion.TangentAt(0))) > StraightSine
                : IsCorner(path, at, m, step, isForeign);
            if (leaves || room < 0 || before.TangentAt(1).Dot(behind.TangentAt(0)) < BendCosine)
            {
                break;
            }

            at = m;
        }

        return at;
    }

    // True if an arc leads tangentially from one boundary to another. Such a rounded corner belongs to neither; the program rewriter
    // keeps it tangent to both.
    private static bool IsCorner(NcPath path, int at, int motion, int step, Func<int, bool> isForeign)
    {
        var next = Next(path, motion, step);
        return path.Motions[motion].IsArc && next >= 0 && next < path.Motions.Length && isForeign(next) && path.Motions[next].IsCut
            && IsTangent(Math.Min(at, motion), Math.Max(at, motion)) && IsTangent(Math.Min(motion, next), Math.Max(motion, next));

        bool IsTangent(int before, int behind) =>
            Math.Abs(path.Motions[before].TangentAt(1).Cross(path.Motions[behind].TangentAt(0))) <= StraightSine;
    }

    private static bool Overlap(NcPath path, FoundPass one, FoundPass other) =>
        path.Motions[one.First].Block <= path.Motions[other.Last].Block && path.Motions[other.First].Block <= path.Motions[one.Last].Block;

    /// <summary>A pass: its cut, the motions along all key points, whether it runs from the last point to the first, whether that is the
    /// whole boundary, its required and actual distance, and the two outermost points at both ends.</summary>
    private sealed record Pass(
        FoundPass Cut,
        FoundPass Core,
        bool IsAgainst,
        bool IsWhole,
        double WantedMm,
        double DistanceMm,
        IReadOnlyList<Point2> Begin,
        IReadOnlyList<Point2> End);
}
