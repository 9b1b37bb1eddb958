namespace ErrorMatching.Hmi;

/// <summary>Blocks that the user picked for a feature.</summary>
/// <param name="Feature">The feature's name.</param>
/// <param name="Blocks">The blocks as selectors of a job: <c>N120</c>, <c>N130..N160</c>.</param>
/// <param name="IsMore">True to add them to the feature's blocks, false to replace those.</param>
public sealed record RangeChoice(string Feature, IReadOnlyList<string> Blocks, bool IsMore);
