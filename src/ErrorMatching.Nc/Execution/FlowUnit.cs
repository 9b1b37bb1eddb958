namespace ErrorMatching.Nc;

/// <summary>One program of a file: a main program or a subprogram.</summary>
/// <param name="Index">The file it stands in.</param>
/// <param name="Name">Its name; empty where it has none.</param>
/// <param name="First">Its first block.</param>
/// <param name="End">The first block behind it.</param>
internal sealed record FlowUnit(FlowIndex Index, string Name, int First, int End);
