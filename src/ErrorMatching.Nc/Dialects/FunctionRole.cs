namespace ErrorMatching.Nc;

/// <summary>What an M function does to the run of a program.</summary>
public enum FunctionRole : byte
{
    /// <summary>Not in the table.</summary>
    Unknown,

    /// <summary>Changes no position and no mode: spindle, coolant, tool, a stop.</summary>
    Harmless,

    /// <summary>Calls a program.</summary>
    Call,

    /// <summary>Ends the program.</summary>
    ProgramEnd,

    /// <summary>Ends a subprogram; in a main program, the program.</summary>
    Return,

    /// <summary>May change modes or positions: nothing is known behind it until the program states it again.</summary>
    Unsure,
}
