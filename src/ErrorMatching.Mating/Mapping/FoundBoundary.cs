using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>The result of a search for a boundary.</summary>
/// <param name="Passes">The passes that cut it, in the order of the program; empty if it was not found.</param>
/// <param name="Refusal">Why it was not found, or null.</param>
public sealed record FoundBoundary(IReadOnlyList<FoundPass> Passes, Refusal? Refusal = null);
