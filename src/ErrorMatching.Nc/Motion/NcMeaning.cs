namespace ErrorMatching.Nc;

/// <summary>What a G code means to the interpreter. The dialect's table says which code means what.</summary>
public enum NcMeaning : byte
{
    /// <summary>Not in the table.</summary>
    Unknown,

    /// <summary>Changes no position: modes of feed, spindle, smoothing and the like.</summary>
    Harmless,

    /// <summary>Positioning.</summary>
    Rapid,

    /// <summary>Straight cut.</summary>
    Line,

    /// <summary>Clockwise arc.</summary>
    ArcClockwise,

    /// <summary>Counter-clockwise arc.</summary>
    ArcCounterClockwise,

    /// <summary>Probing move.</summary>
    Probe,

    /// <summary>Moves nothing although it has axis words: a wait, whose X is a time, or limits of travel.</summary>
    Dwell,

    /// <summary>Plane X Y.</summary>
    PlaneXY,

    /// <summary>Plane Z X.</summary>
    PlaneZX,

    /// <summary>Plane Y Z.</summary>
    PlaneYZ,

    /// <summary>Lengths in inches.</summary>
    Inch,

    /// <summary>Lengths in millimetres.</summary>
    Metric,

    /// <summary>Coordinates are positions.</summary>
    Absolute,

    /// <summary>Coordinates are increments.</summary>
    Incremental,

    /// <summary>Arc centers are positions.</summary>
    AbsoluteCenters,

    /// <summary>Arc centers are increments from the start.</summary>
    IncrementalCenters,

    /// <summary>Cutter compensation off.</summary>
    CompensationOff,

    /// <summary>Cutter compensation left of the path.</summary>
    CompensationLeft,

    /// <summary>Cutter compensation right of the path.</summary>
    CompensationRight,

    /// <summary>Chooses a work offset.</summary>
    WorkOffset,

    /// <summary>Shifts the origin or writes offsets; its axis words are not a motion.</summary>
    SetOrigin,

    /// <summary>Return to or over a reference point.</summary>
    ReferenceReturn,

    /// <summary>The block's coordinates are the machine's.</summary>
    MachineCoordinates,

    /// <summary>Begins a rotation, scaling, mirroring or polar mode; its axis words are not a motion.</summary>
    TransformOn,

    /// <summary>Ends such a mode.</summary>
    TransformOff,

    /// <summary>A canned cycle.</summary>
    Cycle,

    /// <summary>Ends canned cycles.</summary>
    CycleOff,

    /// <summary>Calls a program or macro.</summary>
    Call,
}
