namespace ErrorMatching.Hmi;

/// <summary>A feature of a job with the blocks that cut it, in the words of the job.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Blocks">Selectors as they stand in the job: <c>N120</c>, <c>N130..N160</c>, <c>/expression/</c>.</param>
public sealed record FeatureBlocks(string Name, IReadOnlyList<string> Blocks);
