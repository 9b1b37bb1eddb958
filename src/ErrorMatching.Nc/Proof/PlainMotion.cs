namespace ErrorMatching.Nc;

/// <summary>Tells whether a block's words alone determine where its motion goes. It lists what is allowed, while the rewriter lists what
/// is not: a case that neither foresees is not a plain motion.</summary>
internal static class PlainMotion
{
    private const MotionFlags Plain = MotionFlags.Inch | MotionFlags.Incremental | MotionFlags.AbsoluteCenter | MotionFlags.ByRadius
        | MotionFlags.CompensationLeft | MotionFlags.CompensationRight | MotionFlags.CompensationSwitches | MotionFlags.StartsElsewhere
        | MotionFlags.CenterBefore | MotionFlags.PolarEnd;

    // A computed word does so, too, if its value is known: the rest of the program says which value its variables have.
    public static bool Is(in NcMotion motion) =>
        ((motion.Flags & ~MotionFlags.Expression) | Plain) == Plain
            && (motion.IsCut || motion.Kind == MotionKind.Rapid)
            && (!motion.Has(MotionFlags.Expression) || (motion.UnknownEnd & motion.Plane.Axes()) == AxisSet.None);
}
