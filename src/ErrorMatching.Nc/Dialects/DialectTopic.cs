namespace ErrorMatching.Nc;

/// <summary>Topic of a dialect's statement.</summary>
public enum DialectTopic : byte
{
    /// <summary>A number or switch: increments, tolerances, spelling.</summary>
    Setting,

    /// <summary>G codes and keywords.</summary>
    Code,

    /// <summary>Letters and multi-letter addresses.</summary>
    Letter,

    /// <summary>M functions.</summary>
    Function,

    /// <summary>Words that branch, loop or define programs.</summary>
    Flow,

    /// <summary>Programs stored in the machine.</summary>
    MachineProgram,

    /// <summary>Something that the control refuses in a block.</summary>
    Refusal,
    /// <summary>What G10 writes, by its L word.</summary>
    OffsetTable,

    /// <summary>A statement about the control without data.</summary>
    Note,
}
