namespace ErrorMatching.Mating;

/// <summary>What was found of a sought boundary.</summary>
/// <param name="Passes">The passes that cut it, in the order of the program; none where it was not found.</param>
/// <param name="Refusal">Why it was not found; null where it was.</param>
public sealed record FoundBoundary(IReadOnlyList<FoundPass> Passes, MatingRefusal? Refusal = null);
