namespace ErrorMatching.Cell;

/// <summary>How a program's run ended.</summary>
internal enum ToolEnd
{
    /// <summary>It exited; see the exit code.</summary>
    Exited,

    /// <summary>Killed at the time limit.</summary>
    TimedOut,

    /// <summary>Killed because its output or download exceeded the limit.</summary>
    TooMuch,

    /// <summary>The program is not installed.</summary>
    Missing,
}
