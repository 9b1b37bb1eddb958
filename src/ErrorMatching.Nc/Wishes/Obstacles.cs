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
        // A computed place that nobody knows before the control runs.
        if (motion.Has(MotionFlags.Expression) && !motion.IsKnownInPlane && motion.IsCut)
        {
            return BlockRefusal.At(
                path.Program,
                motion.Block,
                NcRefusalCodes.Expression,
                "a coordinate is computed by the control from a value that only the machine knows. Post plain numbers for the blocks to "
                    + "change.");
        }

        var block = motion.Block;
        if (motion.Has(MotionFlags.UnknownWord | MotionFlags.UnsureMode)
            && path.Problems.FirstOrDefault(p => p.Block <= block && p.Code == NcRefusalCodes.RefusedByControl) is { } refused)
        {
            return BlockRefusal.At(path.Program, refused.Block, refused.Code,
                refused.Message + " The program stops there: correct this block before you change anything from it on.");
        }

        var (code, why) = Reason(motion, path.IsLead(motion));
        return code is null ? null : BlockRefusal.At(path.Program, motion.Block, code, why!);
    }

    /// <summary>The refusal of a motion whose place the program does not state.</summary>
    public static Refusal UnknownPlace(NcPath path, int motion) => BlockRefusal.At(
        path.Program,
        path.Motions[motion].Block,
        NcRefusalCodes.UnknownState,
        "the program does not say where this motion begins. State X, Y and Z before it.");

    /// <summary>The refusal of a word that the control computes and to which nothing can be added.</summary>
    public static Refusal Computed(NcPath path, in NcMotion motion) => BlockRefusal.At(
        path.Program,
        motion.Block,
        NcRefusalCodes.Expression,
        "a coordinate, center or radius that must change is computed by the control (variable or expression), and a number added to it "
            + "would not do. Post plain numbers for the blocks to change.");

    private static (string? Code, string? Why) Reason(in NcMotion m, bool isLead)
    {
        if (m.Kind is MotionKind.Cycle or MotionKind.Reference or MotionKind.Probe
            || (m.Kind == MotionKind.Spline && !isLead)
            || m.Has(MotionFlags.Cycle)
            || m.Has(MotionFlags.MachineMove))
        {
            return (
                NcRefusalCodes.NotASimpleMove,
                "a canned cycle, spline, probing, reference or machine-coordinate move cannot be displaced. Leave this block out.");
        }

        var why = m.Flags switch
        {
            _ when m.Has(MotionFlags.Conditional) =>
                (NcRefusalCodes.Expression, "it is cut only under its condition (IF). Post it without one, or leave this block out."),
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
