namespace ErrorMatching.Hmi;

/// <summary>The blocks of a feature, as a person wants to see them.</summary>
/// <param name="Feature">Its name.</param>
/// <param name="Blocks">From its first block to its last.</param>
/// <param name="IsAtEnd">True for their end, where they have no room together; else their beginning is shown.</param>
public sealed record FeatureLook(string Feature, BlockRange Blocks, bool IsAtEnd);
