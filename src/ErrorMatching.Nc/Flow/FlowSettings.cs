namespace ErrorMatching.Nc;

/// <summary>Resources and limits of a running program.</summary>
internal sealed record FlowSettings
{
    /// <summary>Returns a program that is not in the file by its name (<c>O1002</c>, <c>L10</c>, <c>POCKET</c>, <c>bore</c>), or null if
    /// there is none. The caller decides which files may be opened.</summary>
    public Func<string, NcProgram?> Library { get; init; } = _ => null;

    /// <summary>Says which way the program goes where only the machine knows it; null if both ways do not lead to the same.</summary>
    public Func<bool?>? Decide { get; init; }

    /// <summary>Called when a pass of a call ends, with the depth of that call: 1 if the main program called.</summary>
    public Action<int> Returned { get; init; } = _ => { };

    /// <summary>Maximum work where the program does not run straight through, in blocks of usual length.</summary>
    public long Steps { get; init; } = 10_000_000;

    /// <summary>Maximum depth of nested calls.</summary>
    public int Depth { get; init; } = 100;

    /// <summary>Cancels the run.</summary>
    public CancellationToken Cancellation { get; init; }
}
