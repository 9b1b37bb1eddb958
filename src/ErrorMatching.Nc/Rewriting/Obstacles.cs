using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Reports why a motion's words cannot be changed.</summary>
internal static class Obstacles
{
    /// <summary>The reason why a motion cannot be changed; null if it can.</summary>
    public static Refusal? Of(NcPath path, int motion) => Of(path, path.Motions[motion]);

    /// <summary>The same for a motion that the caller has already read.</summary>
    public static Refusal? Of(NcPath path, in NcMotion motion)
    {
        var (code, why) = Reason(motion);
        return code is null ? null : BlockRefusal.At(path.Program, motion.Block, code, why!);
    }

    /// <summary>The refusal of a motion whose place the program does not state.</summary>
    public static Refusal UnknownPlace(NcPath path, int motion) => BlockRefusal.At(
        path.Program,
        path.Motions[motion].Block,
        NcRefusalCodes.UnknownState,
        "the program does not say where this motion begins. State X, Y and Z before it.");

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
                    "an origin is set or a program is called here while the tool stands at a place that would move; what follows could "
                        + "move along. Move the tool away from the contour before it.");
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

    private static (string? Code, string? Why) Reason(in NcMotion m)
    {
        if (m.Kind is MotionKind.Cycle or MotionKind.Reference or MotionKind.Probe or MotionKind.Spline
            || m.Has(MotionFlags.Cycle)
            || m.Has(MotionFlags.MachineMove))
        {
            return (
                NcRefusalCodes.NotASimpleMove,
                "a canned cycle, spline, probing, reference or machine-coordinate move cannot be displaced. Leave this block out.");
        }

        var why = m.Flags switch
        {
            _ when m.Has(MotionFlags.Called) =>
                (NcRefusalCodes.NotASimpleMove, "it is part of a program in another file that is called here. Displace that program."),
            _ when m.Has(MotionFlags.Expression) =>
                (
                    NcRefusalCodes.Expression,
                    "a coordinate is computed by the control (variable or expression). Post plain numbers for the blocks to change."),
            _ when m.Has(MotionFlags.UnknownWord) =>
                (
                    NcRefusalCodes.UnknownWord,
                    "it has a word that the dialect does not know and that could move an axis. Choose the control's dialect, or leave "
                        + "this block out."),
            _ when m.Has(MotionFlags.Transformed) =>
                (
                    NcRefusalCodes.ActiveTransform,
                    "rotation, scaling, mirroring or polar coordinates are active. Post the program without them."),
            _ when m.Has(MotionFlags.OtherAxis) =>
                (NcRefusalCodes.OtherAxis, "a rotary or secondary axis moves along. Only X, Y and Z can be displaced."),
            _ when m.Has(MotionFlags.UnsureMode) =>
                (
                    NcRefusalCodes.UnknownState,
                    "a called program or unknown code before it could have changed the modes. State G0/G1, G90/G91, the plane and "
                        + "G40/G41/G42 again behind it."),
            _ when m.Has(MotionFlags.CornerWord) => (
                NcRefusalCodes.CornerWord,
                "a corner word (RND, CHF, ,R or ,C) rounds the vertex that must move. Post the arc or chamfer itself."),
            _ when m.Has(MotionFlags.OtherArcForm) =>
                (
                    NcRefusalCodes.ArcForm,
                    "the arc is given by an opening angle, a point on its way, or the direction before it. Post it with its center or "
                        + "radius."),
            _ when m.Has(MotionFlags.BadArc) => (NcRefusalCodes.BadArc, "its words describe no circle within the control's tolerance."),
            _ => default,
        };
        return why;
    }
}
