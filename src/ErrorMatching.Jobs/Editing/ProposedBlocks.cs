namespace ErrorMatching.Jobs;

/// <summary>Blocks that seem to cut a feature of a draft, to be looked at before they are used.</summary>
/// <param name="Feature">Number of the feature in the draft.</param>
/// <param name="Name">Its name.</param>
/// <param name="Blocks">Selectors of the blocks; none if they were not found.</param>
public sealed record ProposedBlocks(int Feature, string Name, IReadOnlyList<string> Blocks);
