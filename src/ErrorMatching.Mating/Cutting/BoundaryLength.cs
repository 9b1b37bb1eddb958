using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Lengths along the boundary at a distance to the left of a path. There, each piece of the path is longer or shorter by that
/// distance times the angle it turns. Each joint of a polyline contributes half its angle to either side, so a fine polyline measures the
/// same as the curve it approximates.</summary>
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
        var lengths = new double[last - first + 1];
        int[] moving = [.. FeaturePass.Moving(path, first, last)];
        for (var k = 0; k < moving.Length; k++)
        {
            var motion = path.Motions[moving[k]];
            var joints = (k > 0 ? Turn(path, moving[k - 1], moving[k]) : 0)
                + (k < moving.Length - 1 ? Turn(path, moving[k], moving[k + 1]) : 0);
            var turned = (motion.IsArc ? motion.Arc.Sweep.Radians : 0) + (joints / 2);

            // Where the tool rounds an inside corner, the boundary has no length of its own; a small length keeps the points in order.
            lengths[moving[k] - first] = Math.Max(motion.PlaneLength - (left * turned), 0.01 * motion.PlaneLength);
        }

        for (var i = 0; i < lengths.Length; i++)
        {
            starts[i + 1] = starts[i] + lengths[i];
        }

        return starts;
    }

    private static double Turn(NcPath path, int before, int behind)
    {
        var (from, to) = (path.Motions[before].TangentAt(1), path.Motions[behind].TangentAt(0));
        return Elementary.Atan2(from.Cross(to), from.Dot(to));
    }
}
