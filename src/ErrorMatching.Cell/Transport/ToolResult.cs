namespace ErrorMatching.Cell;

/// <summary>The result of a program's run.</summary>
/// <param name="End">How it ended.</param>
/// <param name="ExitCode">Its exit code, if it exited.</param>
/// <param name="Output">Its standard output.</param>
/// <param name="Error">The beginning of its standard error, at most 16 KB.</param>
internal sealed record ToolResult(ToolEnd End, int ExitCode, byte[] Output, string Error);
