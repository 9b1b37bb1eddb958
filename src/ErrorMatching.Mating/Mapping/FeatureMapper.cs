using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Finds the place of each theoretical key point on the path of its feature's blocks. Without cutter compensation, all points
/// must be one tool radius from the path and on the same side, which is the side of the counterpart's material. Under G41 or G42 they are
/// on the path, and the code defines the material side.</summary>
internal static class FeatureMapper
{
    /// <summary>Code of the refusal of a key point that is too far from its blocks.</summary>
    public const string PointOffPath = "point-off-path";

    /// <summary>Code of the refusal of key points on both sides of the path.</summary>
    public const string SidesDiffer = "sides-differ";

    /// <summary>Code of the refusal of blocks in another plane than the feature's.</summary>
    public const string PlaneDiffers = "plane-differs";

    /// <summary>Code of the refusal of blocks that two features name.</summary>
    public const string BlocksOverlap = "blocks-overlap";

    /// <summary>Code of the refusal of another program than that for which the blocks were chosen.</summary>
    public const string ProgramChanged = "program-changed";

    /// <summary>Cosine of the angle from which a point counts as beside its motion: 5 degrees.</summary>
    private const double CornerCosine = 0.996;

    // Motions meet if no word of a program could separate their ends.
    private const double SamePlaceMm = 1e-6;

    /// <summary>Maps all features of a job.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <param name="maps">For each feature of the job, in order, its map; complete only if nothing is refused.</param>
    /// <returns>Why a feature cannot be mapped, or null.</returns>
    /// <exception cref="InputException">A key point is missing in the theoretical file, or has no coordinate in the feature's
    /// plane. A selector cannot be read.</exception>
    public static Refusal? Map(MatingJob job, NcPath path, MeasurementFile theoretical, out IReadOnlyList<FeatureMap> maps)
    {
        var found = new List<FeatureMap>();
        maps = found;
        if (Changed(job, path.Program) is { } changed)
        {
            return changed;
        }

        var owners = new Dictionary<int, string>();
        foreach (var feature in job.Features)
        {
            var selection = BlockSelector.Select(path.Program, [.. feature.Blocks.Select(BlockSelector.Parse)]);
            if (!selection.IsUsable)
            {
                return FeatureRefusal.Of(selection.Refusal, feature.Name);
            }

            foreach (var block in selection.Result)
            {
                if (!owners.TryAdd(block, feature.Name))
                {
                    return FeatureRefusal.At(
                        path,
                        block,
                        BlocksOverlap,
                        $"it belongs to {owners[block]} and to {feature.Name}. Name each block once.",
                        feature.Name);
                }
            }

            var refusal = Map(job, path, feature, selection.Result, theoretical, out var map);
            if (refusal is not null)
            {
                return refusal;
            }

            found.Add(map!);
        }

        return null;
    }

    /// <summary>Why a program is not the one for which the job's blocks were chosen; null if it is, or if the job does not say.</summary>
    internal static Refusal? Changed(MatingJob job, NcProgram program) =>
        job.Counterpart.ProgramSha256 is { } stated
        && ContentHash.Sha256(program.Bytes.Span) is var found && found != stated
            ? new(
                ProgramChanged,
                $"The program has the SHA-256 {found}, the job was made for {stated}: it was edited, or it is another program. "
                    + (Marker.Find(program).Count > 0
                        ? "It carries the marker of a correction, which is one line more: blocks that are named by lines are one line "
                            + "further on behind it. "
                        : "")
                    + "Check the blocks of all features, then write the new SHA-256 to programSha256.")
            : null;

    private static Refusal? Map(
        MatingJob job, NcPath path, JobFeature feature, int[] blocks, MeasurementFile theoretical, out FeatureMap? map)
    {
        map = null;
        var passes = Passes(path, blocks, feature.Plane);
        if (passes.Count == 0)
        {
            return FeatureRefusal.At(path, blocks[0], NcRefusalCodes.NoMotion, "the named blocks hold no cutting motion.", feature.Name);
        }

        var mapped = new List<FeaturePass>();
        foreach (var (first, last) in passes)
        {
            for (var i = first; i <= last; i++)
            {
                if (Unplaceable(path.Motions[i], feature.Plane) is { } why)
                {
                    return FeatureRefusal.At(path, path.Motions[i].Block, why.Code, why.Message, feature.Name);
                }
            }

            var feet = new List<KeyPointFoot>();
            foreach (var label in feature.Points)
            {
                var point = job.Counterpart.PlaceOf(theoretical[label], feature.Plane, theoretical.File);
                var refusal = Foot(job, path, feature, label, point, first, last, out var foot);
                if (refusal is not null)
                {
                    return refusal;
                }

                feet.Add(foot!);
            }

            if (feet.Find(f => f.MaterialIsLeft != feet[0].MaterialIsLeft) is { } other)
            {
                return FeatureRefusal.At(
                    path,
                    path.Motions[other.Motion].Block,
                    SidesDiffer,
                    $"the points {feet[0].Label} and {other.Label} lie on different sides of the path, so the material cannot be told. "
                        + $"Check the frame and the points.",
                    feature.Name,
                    other.Label);
            }

            var compensated = path.Motions[first].Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight);
            var left = compensated ? 0 : (feet[0].MaterialIsLeft ? 1 : -1) * job.Counterpart.ToolDiameterMm / 2;
            mapped.Add(new(first, last, BoundaryLength.Starts(path, first, last, left), feet));
            var opposite = feet.FindIndex(f => f.Normal.Dot(mapped[0].Feet[feet.IndexOf(f)].Normal) < 0);
            if (opposite >= 0)
            {
                var foot = feet[opposite];
                return FeatureRefusal.At(
                    path,
                    path.Motions[foot.Motion].Block,
                    SidesDiffer,
                    $"here the tool is on the other side of the point {foot.Label} than in "
                        + $"{NameOf(path, mapped[0].Feet[opposite].Motion)}, so the material cannot be told. Name only the blocks that "
                            + $"cut this "
                        + $"boundary.",
                    feature.Name,
                    foot.Label);
            }
        }

        var toPart = job.Counterpart.Frame.Inverse();
        map = new(feature, blocks, mapped, [.. mapped[0].Feet.Select(f => toPart.Apply(f.Normal))]);
        return feature.RefuseMap(path, map);
    }

    // Why the position of a motion in the feature's plane is unknown, or null.
    private static (string Code, string Message)? Unplaceable(in NcMotion motion, CoordinatePlane plane) => motion switch
    {
        _ when motion.Has(MotionFlags.Expression) && !motion.IsKnownInPlane =>
            (
                NcRefusalCodes.Expression,
                "the control computes where it goes from a value that only the machine knows. Post plain numbers for the blocks of a "
                    + "feature."),
        _ when motion.Has(MotionFlags.Transformed) =>
            (
                NcRefusalCodes.ActiveTransform,
                "rotation, scaling, mirroring or polar coordinates are active. Post the program without them."),
        _ when motion.Plane != plane =>
            (PlaneDiffers, $"it cuts in the plane {motion.Plane}, the feature lies in {plane}. Set \"plane\" in the job."),
        _ when !motion.IsKnownInPlane =>
            (NcRefusalCodes.UnknownState, "the program does not say where this motion begins or ends. State X, Y and Z before it."),
        _ when motion.Has(MotionFlags.BadArc) => (NcRefusalCodes.BadArc, "its words describe no circle within the control's tolerance."),
        _ => null,
    };

    // Named cuts that follow one another with no motion in between. An upright arc leads to a contour in XY and follows it.
    private static List<(int First, int Last)> Passes(NcPath path, int[] blocks, CoordinatePlane plane)
    {
        var passes = new List<(int First, int Last)>();
        foreach (var motion in blocks.SelectMany(b => path.MotionsOf(b).ToArray()).Order())
        {
            if (path.Motions[motion] is not { IsCut: true, MovesInPlane: true } cut || (cut.IsVertical && plane == CoordinatePlane.XY))
            {
                continue;
            }

            if (passes.Count > 0 && Continues(path, passes[^1].Last, motion))
            {
                passes[^1] = (passes[^1].First, motion);
            }
            else
            {
                passes.Add((motion, motion));
            }
        }

        return passes;
    }

    // True if only blocks without length are between two cuts; some CAM systems and cut corners leave such blocks.
    private static bool Continues(NcPath path, int last, int next)
    {
        for (var i = last + 1; i < next; i++)
        {
            if (!path.Motions[i].IsCut || path.Motions[i].End != path.Motions[i].Start)
            {
                return false;
            }
        }

        return true;
    }

    private static Refusal? Foot(
        MatingJob job, NcPath path, JobFeature feature, string label, Point2 point, int first, int last, out KeyPointFoot? foot)
    {
        var (nearest, nearestDistance, nearestFraction) = (first, double.PositiveInfinity, 0.0);
        for (var i = first; i <= last; i++)
        {
            var motion = path.Motions[i];
            if (!motion.MovesInPlane)
            {
                continue;
            }

            var fraction = motion.IsArc ? motion.Arc.NearestFraction(point) : motion.Segment.NearestFraction(point);
            var distance = motion.PlaneAt(fraction).DistanceTo(point);
            if (distance < nearestDistance)
            {
                (nearest, nearestDistance, nearestFraction) = (i, distance, fraction);
            }
        }

        var found = path.Motions[nearest];
        var compensated = found.Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight);
        var wanted = compensated ? 0 : job.Counterpart.ToolDiameterMm / 2;
        var left = found.TangentAt(nearestFraction).Left;
        var side = (point - found.PlaneAt(nearestFraction)).Dot(left);
        var materialIsLeft = compensated ? found.Has(MotionFlags.CompensationRight) : side > 0;
        var onCorner = Math.Abs(side) < CornerCosine * nearestDistance && wanted > 0;
        var normal = onCorner ? (found.PlaneAt(nearestFraction) - point).Normalize() : materialIsLeft ? -left : left;
        foot = new(label, nearest, nearestFraction, nearestDistance, normal, materialIsLeft, onCorner)
        {
            BeyondEndMm = onCorner ? BeyondEnd(path, point, nearest, last, nearestDistance) : 0
        };
        if (Math.Abs(nearestDistance - wanted) <= job.Counterpart.MapMm)
        {
            return null;
        }

        var where = compensated
            ? "on the path, since cutter compensation is active"
            : string.Create(CultureInfo.InvariantCulture, $"{wanted:0.###} mm from it, one tool radius");
        return FeatureRefusal.At(
            path,
            found.Block,
            PointOffPath,
            string.Create(
                CultureInfo.InvariantCulture,
                $"the theoretical point {label} lies {nearestDistance:0.000} mm from the path, expected {where} (within "
                    + $"{job.Counterpart.MapMm:0.###} mm). Check the frame, the tool diameter and the blocks."),
            feature.Name,
            label) with
        { Found = CutFit.FoundMm(nearestDistance) };
    }

    // Of the motions that meet at the vertex, use the one that the point is least beyond; the first need not be the point's own.
    private static double BeyondEnd(NcPath path, Point2 point, int nearest, int last, double distance)
    {
        var least = double.PositiveInfinity;
        for (var i = nearest; i <= last; i++)
        {
            var motion = path.Motions[i];
            if (!motion.MovesInPlane)
            {
                continue;
            }

            var fraction = motion.IsArc ? motion.Arc.NearestFraction(point) : motion.Segment.NearestFraction(point);
            var fromFoot = point - motion.PlaneAt(fraction);
            least = fromFoot.Length <= distance + SamePlaceMm ? Math.Min(least, Math.Abs(fromFoot.Dot(motion.TangentAt(fraction)))) : least;
        }

        return least;
    }

    private static string NameOf(NcPath path, int motion) => path.Program.NameOf(path.Program[path.Motions[motion].Block]);
}
