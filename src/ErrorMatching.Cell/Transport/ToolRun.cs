namespace ErrorMatching.Cell;

/// <summary>A program's run: its input and its limits.</summary>
/// <param name="Program">Name of the program, found by PATH.</param>
/// <param name="Arguments">Its arguments, one by one; no shell reads them. No secrets: every user of the computer can see them.</param>
/// <param name="Input">Its standard input.</param>
/// <param name="Limit">Time limit; the program is killed after it.</param>
internal sealed record ToolRun(string Program, IReadOnlyList<string> Arguments, ReadOnlyMemory<byte> Input, TimeSpan Limit)
{
    /// <summary>Output limit; the program is killed above it.</summary>
    public long MostOutput { get; init; } = 4 << 20;
}

/// <summary>The result of a program's run.</summary>
/// <param name="End">How it ended.</param>
/// <param name="ExitCode">Its exit code, if it exited.</param>
/// <param name="Output">Its standard output.</param>
/// <param name="Error">The beginning of its standard error, at most 16 KB.</param>
internal sealed record ToolResult(ToolEnd End, int ExitCode, byte[] Output, string Error);

/// <summary>How a program's run ended.</summary>
internal enum ToolEnd
{
    /// <summary>It exited; see the exit code.</summary>
    Exited,

    /// <summary>Killed at the time limit.</summary>
    TimedOut,

    /// <summary>Killed because its output exceeded the limit.</summary>
    TooMuch,

    /// <summary>The program is not installed.</summary>
    Missing,
}
