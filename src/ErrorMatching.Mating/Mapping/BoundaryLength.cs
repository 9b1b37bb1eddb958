using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>
/// Lengths along the boundary that a path leaves at a distance to its left: each piece of the path is longer or shorter there by that distance times the angle it turns.
/// What a joint of a polyline turns belongs half to each side, so a fine polyline is measured like the curve it stands for.
/// </summary>
internal static class BoundaryLength
{
    /// <summary>Length of the boundary before each motion of a pass, and at its end.</summary>
    /// <param name="path">The path.</param>
    /// <param name="first">First motion of the pass.</param>
    /// <param name="last">Last motion of the pass.</param>
    /// <param name="left">Signed distance of the boundary to the left of the path, mm.</param>
    public static double[] Starts(NcPath path, int first, int last, double left)
    {
        var starts = new double[last - first + 2];
        for (var i = first; i <= last; i++)
        {
            var motion = path.Motions[i];
            var turned = (motion.IsArc ? motion.Arc.Sweep.Radians : 0) + (((i > first ? Turn(path, i) : 0) + (i < last ? Turn(path, i + 1) : 0)) / 2);

            // Where the tool rounds an inside corner the boundary has no length of its own; a little keeps the order of places.
            starts[i - first + 1] = starts[i - first] + Math.Max(motion.PlaneLength - (left * turned), 0.01 * motion.PlaneLength);
        }

        return starts;
    }

    private static double Turn(NcPath path, int motion)
    {
        var (before, behind) = (path.Motions[motion - 1].TangentAt(1), path.Motions[motion].TangentAt(0));
        return Math.Atan2(before.Cross(behind), before.Dot(behind));
    }
}
