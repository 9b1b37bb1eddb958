namespace ErrorMatching.Peers.Tests;

/// <summary>What a random program is about.</summary>
public enum Topic
{
    /// <summary>Lines and rapids, G90 and G91, modal words left out.</summary>
    Lines,

    /// <summary>Arcs by I J K, incremental and absolute centers.</summary>
    ArcsByCenter,

    /// <summary>Arcs by R of both signs.</summary>
    ArcsByRadius,

    /// <summary>Full circles and helices with P turns.</summary>
    Turns,

    /// <summary>All of these in three planes.</summary>
    Planes,

    /// <summary>All of these with G20 and G21 in turn.</summary>
    Units,

    /// <summary>Lower case, spaces inside words and numbers, comments, line ends, block delete.</summary>
    Spelling,

    /// <summary>G93, G94 and G95.</summary>
    Feeds,

    /// <summary>G10 L2 and G54 to G59.3.</summary>
    WorkOffsets,

    /// <summary>The same with an angle.</summary>
    RotatedOffsets,

    /// <summary>G10 L20.</summary>
    TouchedOffsets,

    /// <summary>G92, G92.1, G92.2 and G92.3.</summary>
    SetPositions,

    /// <summary>G52.</summary>
    LocalShifts,

    /// <summary>G53.</summary>
    MachineCoordinates,

    /// <summary>G43.1 and G49.</summary>
    ToolLengths,

    /// <summary>G28 and G30 with positions that are stored by the program.</summary>
    References,

    /// <summary>Canned cycles in the plane XY.</summary>
    Cycles,

    /// <summary>Canned cycles in all planes.</summary>
    CyclesInPlanes,

    /// <summary>Parameters and expressions.</summary>
    Expressions,

    /// <summary>If, while, do, repeat.</summary>
    Flow,

    /// <summary>Subprograms with arguments and results.</summary>
    Subprograms,

    /// <summary>G38.2 to G38.5.</summary>
    Probes,

    /// <summary>G5, G5.1.</summary>
    Splines,

    /// <summary>G41, G42 and G40; the peer gets them blanked out.</summary>
    Compensation,

    /// <summary>Polar words @ and ^.</summary>
    Polar,

    /// <summary>Blocks that are rarely written: a wait beside a motion, a motion code alone, threads.</summary>
    OddBlocks,

    /// <summary>M70 to M73, in subprograms that call one another.</summary>
    SavedModes,

    /// <summary>Everything in one program.</summary>
    Everything,
}
