namespace ErrorMatching.Mating;

/// <summary>The program that was written.</summary>
/// <param name="File">Its file.</param>
/// <param name="Sha256">SHA-256 of its bytes.</param>
/// <param name="ChangedBlocks">Number of blocks that differ from the original.</param>
/// <param name="ChangedWords">Number of words changed or inserted.</param>
/// <param name="Blocks">The blocks that differ, side by side.</param>
public sealed record ReportProgram(string File, string Sha256, int ChangedBlocks, int ChangedWords, IReadOnlyList<ReportBlock> Blocks);
