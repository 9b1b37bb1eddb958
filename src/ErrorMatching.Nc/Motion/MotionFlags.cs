namespace ErrorMatching.Nc;

/// <summary>Further properties of a motion: the modes in which it was programmed, and obstacles to changing it.</summary>
[Flags]
public enum MotionFlags
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>Programmed in inches (G20).</summary>
    Inch = 1,

    /// <summary>Programmed in increments (G91).</summary>
    Incremental = 1 << 1,

    /// <summary>Arc centers are absolute (G90.1).</summary>
    AbsoluteCenter = 1 << 2,

    /// <summary>The arc is programmed by its radius.</summary>
    ByRadius = 1 << 3,

    /// <summary>Cutter compensation left is active (G41): material is to the right of the path.</summary>
    CompensationLeft = 1 << 4,

    /// <summary>Cutter compensation right is active (G42): material is to the left of the path.</summary>
    CompensationRight = 1 << 5,

    /// <summary>Cutter compensation is switched on or off in this block.</summary>
    CompensationSwitches = 1 << 6,

    /// <summary>Rotation, scaling, mirroring or polar coordinates are active.</summary>
    Transformed = 1 << 7,

    /// <summary>The control computes a word of the block.</summary>
    Expression = 1 << 8,

    /// <summary>A rotary or secondary axis moves in the block.</summary>
    OtherAxis = 1 << 9,

    /// <summary>A mode that this motion depends on is unknown, because something before could have changed it.</summary>
    UnsureMode = 1 << 10,

    /// <summary>The block has a corner word (,R or ,C).</summary>
    CornerWord = 1 << 11,

    /// <summary>The block has a word that the dialect does not know, or the control refuses it; a problem says which.</summary>
    UnknownWord = 1 << 12,

    /// <summary>The arc's words do not describe a circle within the control's tolerance.</summary>
    BadArc = 1 << 13,

    /// <summary>The motion is part of a canned cycle.</summary>
    Cycle = 1 << 14,

    /// <summary>The motion uses machine coordinates or a reference point, independent of the workpiece.</summary>
    MachineMove = 1 << 15,

    /// <summary>The block's words run only under its condition (IF).</summary>
    Conditional = 1 << 16,

    /// <summary>It begins at another place than the end of the motion before it: an origin changed in between.</summary>
    StartsElsewhere = 1 << 17,

    /// <summary>The arc is given by an opening angle, an intermediate point, or the direction before it.</summary>
    OtherArcForm = 1 << 18,

    /// <summary>A move to a machine position that does not name X: it ends in X where it begins.</summary>
    CarriesX = 1 << 19,

    /// <summary>The same in Y.</summary>
    CarriesY = 1 << 20,

    /// <summary>The same in Z.</summary>
    CarriesZ = 1 << 21,

    /// <summary>The center of the arc is stated by a block before it (CC).</summary>
    CenterBefore = 1 << 22,

    /// <summary>The end of the arc is an angle about its center (CP). Together with <see cref="Transformed"/>: the end is polar in a form
    /// that is not changed (LP, AP=), and nothing else transforms it.</summary>
    PolarEnd = 1 << 23,
}
