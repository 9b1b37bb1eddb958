namespace ErrorMatching.Nc;

/// <summary>A program, subprogram, macro or subroutine that is being executed.</summary>
internal sealed class FlowFrame
{
    public required FlowUnit Unit { get; init; }

    /// <summary>The first block of each pass.</summary>
    public required int First { get; init; }

    /// <summary>The block that called.</summary>
    public int Caller { get; init; }

    /// <summary>Passes left, the present one included.</summary>
    public long Passes { get; set; } = 1;

    /// <summary>What a call gives to the variables of its level, for each pass anew; null where the level is the caller's.</summary>
    public IReadOnlyList<(VariablePlace Place, NcValue Value)>? Arguments { get; init; }

    /// <summary>The arguments of a Siemens call in their order, each with the variable that it is, if it is one.</summary>
    public List<(NcValue Value, VariablePlace? Place)>? Parameters { get; init; }

    /// <summary>Parameters by reference (Siemens VAR): what is handed back to the caller's variables.</summary>
    public List<(VariablePlace Inside, VariablePlace Outside)> Results { get; } = [];

    /// <summary>True if a modal call behind a motion began it.</summary>
    public bool IsModalMacro { get; init; }

    /// <summary>How many of the modal calls are active in it.</summary>
    public int ModalCalls { get; set; }

    /// <summary>Passes left of counted loops, by the block of the loop.</summary>
    public Dictionary<int, long> Counters { get; } = [];

    /// <summary>Repeated sections, the innermost last.</summary>
    public Stack<FlowRegion> Regions { get; } = new();
}
