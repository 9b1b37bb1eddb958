namespace ErrorMatching.Hmi;

/// <summary>A request to show the blocks of a feature.</summary>
/// <param name="Feature">Its name.</param>
/// <param name="Blocks">From its first block to its last.</param>
/// <param name="IsAtEnd">If they do not all fit: true to show the end, false to show the beginning.</param>
public sealed record FeatureLook(string Feature, BlockRange Blocks, bool IsAtEnd);
