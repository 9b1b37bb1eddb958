using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Whether the ball of a probe has room beside the part.</summary>
/// <remarks>The part fills at most what the counterpart's tool cleared. So a ball that lies wholly in the counterpart's material touches
/// the part nowhere but where it is sent to: its center must be the radius of the ball from everything that the tool cleared.</remarks>
public sealed class ProbeReach
{
    // Rounding of a program's words, and a little of what the program cuts differently from the outline.
    private const double LeastMm = 0.01;

    // A cut that clears more than this beyond the boundary faces it, mm.
    private const double FacedMm = 0.1;

    private readonly List<Cut> _cuts = [];
    private readonly RigidTransform2 _frame;
    private readonly double _limitMm;

    /// <summary>Looks at what a program clears.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it.</param>
    /// <param name="stylusDiameterMm">Diameter of the ball, mm.</param>
    public ProbeReach(MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps, double stylusDiameterMm)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(maps);
        (_frame, StylusRadiusMm, _limitMm) = (job.Counterpart.Frame, stylusDiameterMm / 2, job.Compensation.LimitMm);
        var toolRadius = job.Counterpart.ToolDiameterMm / 2;
        var (unplaced, top, own) = (new List<int>(), DepthMm(path, maps), new FeatureCuts(path, maps));
        for (var i = 0; i < path.Motions.Length; i++)
        {
            var motion = path.Motions[i];

            // The motion of a drilling cycle is the one over its hole.
            var isHole = motion.Kind == MotionKind.Cycle || motion.Has(MotionFlags.Cycle) || motion is { IsCut: true, MovesInPlane: false };
            if (!(motion.IsCut || isHole || motion.Kind == MotionKind.Spline)
                || (own.HoldPlaceOf(i) && IsAbove(Lowest(motion))))
            {
                continue;
            }

            var isKnown = isHole ? (motion.UnknownEnd & (AxisSet.X | AxisSet.Y)) == AxisSet.None : motion.IsKnownInPlane;
            if (motion.Kind == MotionKind.Spline || !isKnown || motion.Plane != CoordinatePlane.XY
                || motion.Has(MotionFlags.Transformed | MotionFlags.BadArc) || !own.HoldPlaceOf(i))
            {
                unplaced.Add(motion.Block);
                continue;
            }

            // Another tool clears at least something there: it is kept away from, and somebody has to look at the rest.
            if (!own.Hold(i))
            {
                unplaced.Add(motion.Block);
            }

            var isBoundary = motion.Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight);
            _cuts.Add(isHole
                ? new(new(motion.PlaneEnd, motion.PlaneEnd), null, isBoundary ? 0 : toolRadius, Lowest(motion))
                : new(motion.Segment, motion.IsArc ? motion.Arc : null, isBoundary ? 0 : toolRadius, Lowest(motion)));
        }

        // Under cutter compensation the path is one side of what is cleared; the tool's center is the middle of it.
        _cuts.AddRange(CompensatedCenters.Of(path).Where(c => !IsAbove(c.LowestMm) && own.HoldPlaceOf(c.Motion))
            .Select(c => new Cut(c.Segment, c.Arc, toolRadius, c.LowestMm)));

        // What is faced over the boundary itself, above all features, says nothing about it.
        Point2[] boundary = [.. maps.SelectMany(m => m.Passes[0].Feet.Select((f, k) => BoundaryAt(path, f, m.Normals[k], toolRadius)))];
        var faced = _cuts.Where(c => c.LowestMm > top + LeastMm).GroupBy(c => Math.Round(c.LowestMm, 2))
            .Where(level => level.Any(c => boundary.Any(at => c.DistanceTo(at) < -FacedMm)))
            .Select(level => level.Key).ToHashSet();
        _cuts.RemoveAll(c => c.LowestMm > top + LeastMm && faced.Contains(Math.Round(c.LowestMm, 2)));
        Unplaced = [.. unplaced.Distinct().Order()];

        // Z0 is the top where the features are below it. Where it is not, nobody knows what is above the part.
        bool IsAbove(double lowest) => top < -LeastMm && lowest >= -LeastMm;
    }

    /// <summary>Blocks that clear something in the part's height of which it is not known where or how wide, because of another tool: the
    /// ball may meet what stands there.</summary>
    public IReadOnlyList<int> Unplaced { get; }

    /// <summary>The height down to which all features are cut, mm: that of the shallowest one. Minus infinity for those of which the
    /// program does not say it.</summary>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it.</param>
    public static double DepthMm(NcPath path, IReadOnlyList<FeatureMap> maps)
    {
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(maps);
        return maps.Max(m => m.Passes.Min(p => FeaturePass.Moving(path, p.First, p.Last).Min(i => Lowest(path.Motions[i]))));
    }

    /// <summary>Radius of the ball, mm.</summary>
    public double StylusRadiusMm { get; }

    /// <summary>The distance from the part at which a measuring move can start, mm; null if the ball has no room at the point
    /// itself.</summary>
    /// <param name="place">The point as designed, in the part's frame.</param>
    /// <param name="normal">Unit normal out of the part's material.</param>
    /// <param name="wantedMm">The distance that is wanted.</param>
    public double? ApproachMm(Point2 place, Vector2 normal, double wantedMm)
    {
        // What the program cuts differently from the outline at the point is no obstacle. What it leaves standing, it leaves elsewhere,
        // too: there, the part as designed is nearer.
        var contact = _frame.Apply(place + (normal * StylusRadiusMm));
        var (lacks, beside) = (RoomMm(contact), RoomMm(_frame.Apply(place)) + StylusRadiusMm);
        if (lacks < -(LeastMm + Math.Abs(beside)))
        {
            return null;
        }

        return MeasuringMove.ApproachMm(
            wantedMm,
            _limitMm,
            off => RoomMm(_frame.Apply(place + (normal * (StylusRadiusMm + off)))) - Math.Min(lacks, 0)
                - Math.Min(off, Math.Max(beside, 0)));
    }

    // The boundary that the program cuts at a key point.
    private Point2 BoundaryAt(NcPath path, KeyPointFoot foot, Vector2 normal, double toolRadius)
    {
        var motion = path.Motions[foot.Motion];
        var isBoundary = motion.Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight);
        return motion.PlaneAt(foot.Fraction) - (_frame.Apply(normal) * (isBoundary ? 0 : toolRadius));
    }

    // Between the ball and what the tool cleared; negative where they overlap.
    private double RoomMm(Point2 center)
    {
        var least = double.PositiveInfinity;
        foreach (var cut in _cuts)
        {
            if (cut.IsNearer(center, least))
            {
                least = Math.Min(least, cut.DistanceTo(center));
            }
        }

        return least - StylusRadiusMm;
    }

    // Where the program does not say how deep, it may be deep.
    private static double Lowest(in NcMotion motion)
    {
        var axis = motion.Plane switch
        {
            CoordinatePlane.ZX => AxisSet.Y,
            CoordinatePlane.YZ => AxisSet.X,
            _ => AxisSet.Z,
        };
        var isKnown = motion.Kind is not (MotionKind.Cycle or MotionKind.Spline) && !motion.Has(MotionFlags.Cycle)
            && (motion.UnknownEnd & axis) == AxisSet.None;
        return isKnown ? Math.Min(motion.Plane.Height(motion.Start), motion.Plane.Height(motion.End)) : double.NegativeInfinity;
    }

    // What one motion clears: all that is nearer to its line than a radius.
    private readonly record struct Cut(Segment2 Segment, Arc2? Arc, double RadiusMm, double LowestMm)
    {
        public double DistanceTo(Point2 place) =>
            (Arc?.DistanceTo(place) ?? (Segment.Start == Segment.End ? Segment.Start.DistanceTo(place) : Segment.DistanceTo(place)))
                - RadiusMm;

        // False if it is certain that it is not.
        public bool IsNearer(Point2 place, double distance) =>
            Segment.Start.DistanceTo(place) - (Arc?.Length ?? Segment.Length) - RadiusMm < distance;
    }
}
