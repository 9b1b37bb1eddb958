namespace ErrorMatching.Nc;

/// <summary>How the control gets from one position to the next.</summary>
public enum MotionKind : byte
{
    /// <summary>Positioning (G0).</summary>
    Rapid,

    /// <summary>A straight cut (G1).</summary>
    Line,

    /// <summary>A clockwise arc, seen against the plane's third axis (G2).</summary>
    ArcClockwise,

    /// <summary>A counter-clockwise arc, seen against the plane's third axis (G3).</summary>
    ArcCounterClockwise,

    /// <summary>A probing move: it may end before its programmed end.</summary>
    Probe,

    /// <summary>A canned cycle that is not followed, at a position; what it does there is the control's affair.</summary>
    Cycle,

    /// <summary>A move whose end is known to the machine only: reference return or machine coordinates.</summary>
    Reference,

    /// <summary>A spline: its end is known, its way is not followed.</summary>
    Spline,
}
