using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Whether the ball of a probe has room beside the counterpart: only where the counterpart's own program cleared all of it, from
/// its lowest point up. What other programs cleared is not known, nor how wide other tools cut.</summary>
public sealed class ClearedRoom
{
    // Rounding of a program's words.
    private const double LeastMm = 0.01;

    private readonly List<(Segment2 Segment, Arc2? Arc)> _centers = [];
    private readonly double _toolRadiusMm;
    private readonly double _ballRadiusMm;
    private readonly double _mapMm;
    private readonly double _limitMm;

    /// <summary>Looks at what a program clears.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it.</param>
    /// <param name="stylusDiameterMm">Diameter of the ball, mm.</param>
    /// <param name="touchZ">Height of the ball's center, mm.</param>
    public ClearedRoom(MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps, double stylusDiameterMm, double touchZ)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(maps);
        (_toolRadiusMm, _ballRadiusMm, _mapMm) = (job.Counterpart.ToolDiameterMm / 2, stylusDiameterMm / 2, job.Counterpart.MapMm);
        _limitMm = job.Compensation.LimitMm;
        var (bottom, own) = (touchZ - _ballRadiusMm + LeastMm, new FeatureCuts(path, maps));
        for (var i = 0; i < path.Motions.Length; i++)
        {
            var motion = path.Motions[i];
            if (own.Hold(i) && motion is { IsCut: true, IsKnownInPlane: true, MovesInPlane: true } && motion.Plane == CoordinatePlane.XY
                && !motion.Has(
                    MotionFlags.Transformed | MotionFlags.BadArc | MotionFlags.CompensationLeft | MotionFlags.CompensationRight)
                && ((motion.UnknownStart | motion.UnknownEnd) & AxisSet.Z) == AxisSet.None
                && Math.Max(motion.Start.Z, motion.End.Z) <= bottom)
            {
                _centers.Add((motion.Segment, motion.IsArc ? motion.Arc : null));
            }
        }

        _centers.AddRange(
            CompensatedCenters.Of(path).Where(c => c.HighestMm <= bottom && own.Hold(c.Motion)).Select(c => (c.Segment, c.Arc)));
    }

    /// <summary>The distance from the counterpart at which a measuring move can start, mm; null if the ball has no room at the point
    /// itself.</summary>
    /// <param name="place">The point as designed, in the program's frame.</param>
    /// <param name="normal">Unit normal out of the counterpart's material.</param>
    /// <param name="wantedMm">The distance that is wanted.</param>
    public double? ApproachMm(Point2 place, Vector2 normal, double wantedMm)
    {
        var beside = DistanceMm(place) - _toolRadiusMm;
        if (Math.Abs(beside) > _mapMm)
        {
            return null;
        }

        // What the program leaves standing at the point is no obstacle for touching it.
        var room = _toolRadiusMm - _ballRadiusMm + Math.Max(beside, 0);
        return MeasuringMove.ApproachMm(wantedMm, _limitMm, off => room - DistanceMm(place + (normal * (_ballRadiusMm + off))));
    }

    private double DistanceMm(Point2 place) => _centers.Count == 0
        ? double.PositiveInfinity
        : _centers.Min(c => c.Arc?.DistanceTo(place) ?? c.Segment.DistanceTo(place));
}
