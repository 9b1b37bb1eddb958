namespace ErrorMatching.Nc;

/// <summary>A program, subprogram, macro or subroutine being executed.</summary>
internal sealed class FlowFrame
{
    public required FlowUnit Unit { get; init; }

    /// <summary>The first block of each pass.</summary>
    public required int First { get; init; }

    /// <summary>The block that called.</summary>
    public int Caller { get; init; }

    /// <summary>True if it is a part of the program that called it, up to the mark that ends such a part.</summary>
    public bool IsPart { get; init; }

    /// <summary>Remaining passes, including the current one.</summary>
    public long Passes { get; set; } = 1;

    /// <summary>Values that a call assigns to the variables of its level, again for each pass; null if it uses the caller's
    /// level.</summary>
    public IReadOnlyList<(VariablePlace Place, NcValue Value)>? Arguments { get; init; }

    /// <summary>The arguments of a Siemens call in order, each with its variable if it is one.</summary>
    public List<(NcValue Value, VariablePlace? Place)>? Parameters { get; init; }

    /// <summary>Parameters by reference (Siemens VAR): values returned to the caller's variables.</summary>
    public List<(VariablePlace Inside, VariablePlace Outside)> Results { get; } = [];

    /// <summary>True if a modal call after a motion began it.</summary>
    public bool IsModalMacro { get; init; }

    /// <summary>Number of modal calls active in it.</summary>
    public int ModalCalls { get; set; }

    /// <summary>Remaining passes of counted loops, by the block of the loop.</summary>
    public Dictionary<int, long> Counters { get; } = [];

    /// <summary>Repeated sections, innermost last.</summary>
    public Stack<FlowRegion> Regions { get; } = new();
}

/// <summary>A section that a REPEAT statement repeats.</summary>
/// <param name="owner">The block of the statement; execution continues after it.</param>
/// <param name="first">First block of the section.</param>
/// <param name="last">Its last block, executed too; equal to <paramref name="owner"/> if the section ends at the statement itself.</param>
/// <param name="passes">Remaining passes, including the current one.</param>
internal sealed class FlowRegion(int owner, int first, int last, long passes)
{
    public int Owner { get; } = owner;

    public int First { get; } = first;

    public int Last { get; } = last;

    public long Passes { get; set; } = passes;
}
