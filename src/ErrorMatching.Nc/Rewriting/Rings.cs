using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Finds closed contours inside a run of cuts: a ring between its lead-in and lead-out returns to a joint of the run.</summary>
internal static class Rings
{
    /// <summary>Sine of the smallest angle of a corner: 5.7 degrees.</summary>
    private const double CornerSine = 0.0995;

    /// <summary>Pairs of inner joints of a run at one place. At least one of them is a corner, or they are both ends of a full circle. If
    /// both are smooth, two paths cross, and they need not keep crossing in one joint. Where the tool goes deeper at a joint, one contour
    /// ends in its upper place and the next begins in its lower one.</summary>
    /// <param name="motions">The path.</param>
    /// <param name="first">First motion of the run.</param>
    /// <param name="last">Last motion of the run.</param>
    public static IEnumerable<(int Start, int End)> Inside(NcMotions motions, int first, int last)
    {
        var corners = new HashSet<Point3>();
        for (var joint = first + 1; joint <= last; joint++)
        {
            if (IsCorner(motions[joint - 1], motions[joint]) || motions.StartOf(joint) == motions.EndOf(joint))
            {
                corners.Add(motions.EndOf(joint - 1));
                corners.Add(motions.StartOf(joint));
            }
        }

        var seen = new Dictionary<Point3, int>();
        for (var joint = first + 1; joint <= last && corners.Count > 0; joint++)
        {
            var (end, start) = (motions.EndOf(joint - 1), motions.StartOf(joint));
            if (corners.Contains(end) && seen.TryGetValue(end, out var before))
            {
                yield return (before, joint);
            }

            seen[end] = joint;
            seen[start] = joint;
        }
    }

    private static bool IsCorner(in NcMotion before, in NcMotion behind)
    {
        if (!HasDirection(before) || !HasDirection(behind) || before.Plane != behind.Plane)
        {
            return false;
        }

        var (a, b) = (before.TangentAt(1), behind.TangentAt(0));
        return Math.Abs(a.Cross(b)) > CornerSine || a.Dot(b) < 0;
    }

    // A damaged arc may begin or end in its own center.
    private static bool HasDirection(in NcMotion motion) =>
        motion is { MovesInPlane: true, IsCut: true }
        && !(motion.IsArc && (motion.PlaneStart == motion.Center || motion.PlaneEnd == motion.Center));
}
