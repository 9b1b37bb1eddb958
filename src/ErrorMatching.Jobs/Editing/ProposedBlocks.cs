using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Blocks that seem to cut a feature, to be checked before use.</summary>
/// <param name="Feature">Index of the feature in the job or draft, from 0.</param>
/// <param name="Name">Its name.</param>
/// <param name="Blocks">Selectors of the blocks; empty if they were not found.</param>
public sealed record ProposedBlocks(int Feature, string Name, IReadOnlyList<string> Blocks)
{
    /// <summary>The first and last block of each pass, as positions in the program; empty if they were not found.</summary>
    public IReadOnlyList<(int First, int Last)> Passes { get; init; } = [];

    /// <summary>Why they were not found, or null.</summary>
    public Refusal? Refusal { get; init; }
}
