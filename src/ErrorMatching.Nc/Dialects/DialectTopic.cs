namespace ErrorMatching.Nc;

/// <summary>What a statement of a dialect is about.</summary>
public enum DialectTopic : byte
{
    /// <summary>A number or switch: increments, tolerances, spelling.</summary>
    Setting,

    /// <summary>G codes and keywords.</summary>
    Code,

    /// <summary>Letters and longer addresses.</summary>
    Letter,

    /// <summary>M functions.</summary>
    Function,

    /// <summary>Words that branch, loop or define programs.</summary>
    Flow,

    /// <summary>Programs that are in the machine.</summary>
    MachineProgram,

    /// <summary>Something that holds of the control and is no data.</summary>
    Note,
}
