namespace ErrorMatching.Hmi;

/// <summary>Blocks that a person chose for a feature.</summary>
/// <param name="Feature">The feature's name.</param>
/// <param name="Blocks">The blocks as selectors of a job: <c>N120</c>, <c>N130..N160</c>.</param>
/// <param name="IsMore">True if they are to be added to what the feature has, false if they take its place.</param>
public sealed record RangeChoice(string Feature, IReadOnlyList<string> Blocks, bool IsMore);
