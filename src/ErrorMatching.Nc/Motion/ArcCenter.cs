using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Finds the center of an arc from the words of a program.</summary>
internal static class ArcCenter
{
    /// <summary>Center of an arc given by its radius. Of the two circles through both ends, a positive radius selects the one whose arc
    /// is at most half a turn, a negative radius the one whose arc is at least half a turn.</summary>
    /// <param name="start">Start in the plane.</param>
    /// <param name="end">End in the plane.</param>
    /// <param name="radius">Signed radius as programmed.</param>
    /// <param name="counterClockwise">Direction of the arc.</param>
    /// <param name="chordTolerance">Allowed excess of the chord over the diameter; the center is then the chord's midpoint.</param>
    /// <returns>The center; null if no circle of this radius reaches both ends.</returns>
    public static Point2? ByRadius(Point2 start, Point2 end, double radius, bool counterClockwise, double chordTolerance)
    {
        var chord = end - start;
        var length = chord.Length;
        if (length == 0 || radius == 0 || length > (2 * Math.Abs(radius)) + chordTolerance)
        {
            return null;
        }

        var half = length / 2;
        var height = Math.Sqrt(Math.Max(0, (radius * radius) - (half * half)));
        var centerIsLeft = counterClockwise == radius > 0;
        return start.Lerp(end, 0.5) + (chord.Left / length * (centerIsLeft ? height : -height));
    }

    /// <summary>Difference of the two radii of an arc.</summary>
    public static double Mismatch(Point2 start, Point2 end, Point2 center) => Math.Abs(start.DistanceTo(center) - end.DistanceTo(center));
}
