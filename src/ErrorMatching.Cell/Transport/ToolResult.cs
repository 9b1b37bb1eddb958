namespace ErrorMatching.Cell;

/// <summary>What came of the run of a program.</summary>
/// <param name="End">How it ended.</param>
/// <param name="ExitCode">Its exit code, if it ended by itself.</param>
/// <param name="Output">What it said.</param>
/// <param name="Error">The beginning of what it said on its other output, at most 16 KB.</param>
internal sealed record ToolResult(ToolEnd End, int ExitCode, byte[] Output, string Error);
