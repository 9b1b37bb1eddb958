namespace ErrorMatching.Nc;

/// <summary>One program of a file: a main program or a subprogram.</summary>
/// <param name="Index">Its file.</param>
/// <param name="Name">Its name; empty if it has none.</param>
/// <param name="First">Its first block.</param>
/// <param name="End">The first block after it.</param>
internal sealed record FlowUnit(FlowIndex Index, string Name, int First, int End);
