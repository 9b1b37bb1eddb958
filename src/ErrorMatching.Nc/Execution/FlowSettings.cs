namespace ErrorMatching.Nc;

/// <summary>What a running program may use.</summary>
internal sealed record FlowSettings
{
    /// <summary>Finds a program that is not in the file, by its name: <c>O1002</c>, <c>L10</c>, <c>POCKET</c>, <c>bore</c>; null where
    /// there is none. What may be opened is the caller's business.</summary>
    public Func<string, NcProgram?> Library { get; init; } = _ => null;

    /// <summary>Called when a pass of a call ends, with the depth of that call: 1 where the main program called.</summary>
    public Action<int> Returned { get; init; } = _ => { };

    /// <summary>Most blocks that are executed where the program does not run straight through.</summary>
    public long Steps { get; init; } = 10_000_000;

    /// <summary>Most calls within calls.</summary>
    public int Depth { get; init; } = 100;

    /// <summary>Ends the run from outside.</summary>
    public CancellationToken Cancellation { get; init; }
}
