using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The place where an uninterrupted cut is nearest to a key point.</summary>
/// <param name="DistanceMm">The distance there.</param>
/// <param name="First">The first motion at that distance.</param>
/// <param name="Last">The last one; differs from the first if two motions meet there.</param>
/// <param name="IsCompensated">True if the control offsets the tool there, so that the path is the boundary.</param>
/// <param name="IsLeft">True if the point is to the left of travel.</param>
/// <param name="IsTwice">True if the cut is equally near elsewhere.</param>
internal readonly record struct SoughtFoot(double DistanceMm, int First, int Last, bool IsCompensated, bool IsLeft, bool IsTwice)
{
    // The same place, where two motions meet.
    private const double SamePlaceMm = 1e-6;

    /// <summary>Finds the foot.</summary>
    public static SoughtFoot Find(NcPath path, FoundPass cut, Point2 point)
    {
        var (best, first, last, left, isTwice) = (double.PositiveInfinity, cut.First, cut.First, 0.0, false);
        for (var m = cut.First; m <= cut.Last; m++)
        {
            var motion = path.Motions[m];
            if (!motion.MovesInPlane)
            {
                continue;
            }

            var fraction = motion.IsArc ? motion.Arc.NearestFraction(point) : motion.Segment.NearestFraction(point);
            var (off, tangent) = (point - motion.PlaneAt(fraction), motion.TangentAt(fraction));
            if (off.Length < best - SamePlaceMm)
            {
                (best, first, last, left, isTwice) = (off.Length, m, m, off.Dot(tangent.Left), false);
            }
            else if (off.Length <= best + SamePlaceMm)
            {
                // Beside a corner the point may be in line with one of the two motions.
                (last, left, isTwice) = Joined(path, last, m) ? (m, left + off.Dot(tangent.Left), isTwice) : (last, left, true);
            }
        }

        return new(
            best, first, last, path.Motions[first].Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight), left > 0, isTwice);
    }

    private static bool Joined(NcPath path, int before, int behind)
    {
        for (var m = before + 1; m < behind; m++)
        {
            if (path.Motions[m].MovesInPlane)
            {
                return false;
            }
        }

        return true;
    }
}
