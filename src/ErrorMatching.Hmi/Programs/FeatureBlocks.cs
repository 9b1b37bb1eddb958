namespace ErrorMatching.Hmi;

/// <summary>A feature of a job with the selectors of its blocks.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Blocks">Selectors as written in the job: <c>N120</c>, <c>N130..N160</c>, <c>/expression/</c>.</param>
public sealed record FeatureBlocks(string Name, IReadOnlyList<string> Blocks);
