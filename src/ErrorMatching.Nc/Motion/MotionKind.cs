namespace ErrorMatching.Nc;

/// <summary>How the control moves from one position to the next.</summary>
public enum MotionKind : byte
{
    /// <summary>Positioning (G0).</summary>
    Rapid,

    /// <summary>A straight cut (G1).</summary>
    Line,

    /// <summary>A clockwise arc, viewed against the plane's third axis (G2).</summary>
    ArcClockwise,

    /// <summary>A counter-clockwise arc, viewed against the plane's third axis (G3).</summary>
    ArcCounterClockwise,

    /// <summary>A probing move: it may end before its programmed end.</summary>
    Probe,

    /// <summary>A canned cycle at a position; its motions there are not followed.</summary>
    Cycle,

    /// <summary>A move whose end only the machine knows: reference return or machine coordinates.</summary>
    Reference,

    /// <summary>A spline: its end is known, but its path is not followed.</summary>
    Spline,
}
