namespace ErrorMatching.Cell;

/// <summary>How the run of a program ended.</summary>
internal enum ToolEnd
{
    /// <summary>By itself; the exit code says more.</summary>
    Exited,

    /// <summary>Killed after its time.</summary>
    TimedOut,

    /// <summary>Killed because it said or fetched more than is taken.</summary>
    TooMuch,

    /// <summary>There is no such program here.</summary>
    Missing,
}
