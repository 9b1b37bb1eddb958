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

    private readonly List<(Segment2 Segment, Arc2? Arc, double RadiusMm)> _cuts = [];
    private readonly RigidTransform2 _frame;

    /// <summary>Looks at what a program clears.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it.</param>
    /// <param name="stylusDiameterMm">Diameter of the ball, mm.</param>
    /// <param name="touchZ">Height of the ball's center, mm; null if it is not known yet.</param>
    public ProbeReach(MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps, double stylusDiameterMm, double? touchZ = null)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(maps);
        (_frame, StylusRadiusMm) = (job.Counterpart.Frame, stylusDiameterMm / 2);

        // What is cut above all features and above the ball, such as the face of the piece, says nothing about their boundary.
        var top = maps.Max(m => m.Passes.Min(p => FeaturePass.Moving(path, p.First, p.Last).Min(i => Lowest(path.Motions[i]))));
        top = Math.Max(top, touchZ ?? top);
        for (var i = 0; i < path.Motions.Length; i++)
        {
            var motion = path.Motions[i];
            if (motion is { IsCut: true, IsKnownInPlane: true, MovesInPlane: true } && motion.Plane == CoordinatePlane.XY
                && !motion.Has(MotionFlags.Transformed | MotionFlags.BadArc) && !(Lowest(motion) > top + LeastMm))
            {
                var isBoundary = motion.Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight);
                _cuts.Add((
                    motion.Segment, motion.IsArc ? motion.Arc : null, isBoundary ? 0 : job.Counterpart.ToolDiameterMm / 2));
            }
        }
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
        // What the program cuts differently from the outline at the point is no obstacle.
        var contact = _frame.Apply(place + (normal * StylusRadiusMm));
        var lacks = RoomMm(contact);
        var beside = Math.Abs(RoomMm(_frame.Apply(place)) + StylusRadiusMm);
        if (lacks < -(LeastMm + beside))
        {
            return null;
        }

        return MeasuringMove.ApproachMm(
            wantedMm,
            off => RoomMm(_frame.Apply(place + (normal * (StylusRadiusMm + off)))) >= Math.Min(lacks, 0) - LeastMm);
    }

    // Between the ball and what the tool cleared; negative where they overlap.
    private double RoomMm(Point2 center)
    {
        var least = double.PositiveInfinity;
        foreach (var (segment, arc, radius) in _cuts)
        {
            if (segment.Start.DistanceTo(center) - (arc?.Length ?? segment.Length) - radius < least)
            {
                least = Math.Min(least, (arc?.DistanceTo(center) ?? segment.DistanceTo(center)) - radius);
            }
        }

        return least - StylusRadiusMm;
    }

    private static double Lowest(in NcMotion motion) =>
        Math.Min(motion.Plane.Height(motion.Start), motion.Plane.Height(motion.End));
}
