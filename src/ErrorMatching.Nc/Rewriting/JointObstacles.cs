using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Reports why the joints of a path must not move.</summary>
internal static class JointObstacles
{
    /// <summary>The reason why the joints of a change must not move, or null: an origin is set or a program is called at the tool's
    /// current place, or the control inserts a rounding or chamfer next to a motion that changes.</summary>
    public static Refusal? Of(PathChange change)
    {
        var path = change.Path;
        foreach (var (block, joint) in path.PlaceDependents)
        {
            if (change.MoveOf(joint) != default)
            {
                return BlockRefusal.At(
                    path.Program,
                    block,
                    NcRefusalCodes.FrameChange,
                    "an origin is set, a program is called, or only the machine knows which way the program goes, while the tool stands "
                        + "at a place that would move; what follows could move along. State what the machine knows (blockSkip, assume), or "
                        + "move the tool away from the contour before it.");
            }
        }

        return CornerOf(change);
    }

    private static Refusal? CornerOf(PathChange change)
    {
        var motions = change.Path.Motions;
        foreach (var motion in change.Affected())
        {
            for (var corner = motion - 1; corner <= motion + 1; corner++)
            {
                if (IsInserted(motions, corner) && !KeepsLine(change, motion))
                {
                    return BlockRefusal.At(
                        change.Path.Program,
                        motions.BlockOf(corner),
                        NcRefusalCodes.CornerWord,
                        "its corner word (RND, CHF, ,R or ,C) rounds the corner to the next block, and one of the two must change: "
                        + "the rounding would move along. Post the arc or chamfer itself.");
                }
            }
        }

        return null;
    }

    // A rounding or chamfer belongs to the block whose end it replaces.
    private static bool IsInserted(NcMotions motions, int motion) => motion > 0 && motion < motions.Length
        && motions.BlockOf(motion) == motions.BlockOf(motion - 1) && motions[motion].Has(MotionFlags.CornerWord);

    // A corner stays exact if the adjacent line gets longer or shorter along an axis; rounding would turn an oblique line.
    private static bool KeepsLine(PathChange change, int motion)
    {
        var m = change.Path.Motions[motion];
        var (start, end) = (change.MoveOf(motion), change.MoveOf(motion + 1));
        if (start == default && end == default && !change.HasCenter(motion))
        {
            return true;
        }

        var along = m.PlaneEnd - m.PlaneStart;
        return !m.IsArc && (along.X == 0 || along.Y == 0) && change.KeepsSense(motion) && IsAlong(start) && IsAlong(end);

        bool IsAlong(Vector3 move) => m.Plane.Height(default(Point3) + move) == 0
            && Math.Abs(along.Cross(m.Plane.Project(default(Point3) + move) - Point2.Origin)) < 1e-9;
    }
}
