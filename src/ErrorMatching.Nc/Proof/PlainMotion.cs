namespace ErrorMatching.Nc;

/// <summary>
/// Says whether a block's words alone tell where its motion goes. It names what may be, where the rewriter names what may not: what
/// neither of them thought of is no plain motion.
/// </summary>
internal static class PlainMotion
{
    private const MotionFlags Plain = MotionFlags.Inch | MotionFlags.Incremental | MotionFlags.AbsoluteCenter | MotionFlags.ByRadius
        | MotionFlags.CompensationLeft | MotionFlags.CompensationRight | MotionFlags.CompensationSwitches | MotionFlags.StartsElsewhere;

    public static bool Is(in NcMotion motion) => (motion.Flags | Plain) == Plain && (motion.IsCut || motion.Kind == MotionKind.Rapid);
}
