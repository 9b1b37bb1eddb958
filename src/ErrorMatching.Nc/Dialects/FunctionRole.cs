namespace ErrorMatching.Nc;

/// <summary>Effect of an M function on the run of a program.</summary>
public enum FunctionRole : byte
{
    /// <summary>Not in the table.</summary>
    Unknown,

    /// <summary>Changes no position and no mode: spindle, coolant, tool, a stop.</summary>
    Harmless,

    /// <summary>Calls a program by its number P (M98).</summary>
    Call,

    /// <summary>Calls a part of the same program, from the block with the number P up to a return (M97).</summary>
    LocalCall,

    /// <summary>Calls a program in a way that is not followed, or from another place (M198): refused.</summary>
    OpaqueCall,

    /// <summary>Ends the program.</summary>
    ProgramEnd,

    /// <summary>Ends a subprogram; in a main program, the program.</summary>
    Return,

    /// <summary>May change modes or positions: nothing is known after it until the program states it again.</summary>
    Unsure,

    /// <summary>Saves the modes of the current call level, to be restored later (M70).</summary>
    SaveModes,

    /// <summary>Saves them, and restores them when the subprogram ends (M73).</summary>
    SaveModesOfCall,

    /// <summary>Restores the saved modes of the current call level (M72).</summary>
    RestoreModes,

    /// <summary>Discards them (M71).</summary>
    DropModes,

    /// <summary>Jumps if an input of the machine says so (M96 of Haas): refused.</summary>
    MachineJump,
}
