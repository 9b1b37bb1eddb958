namespace ErrorMatching.Mating;

/// <summary>Motions that cut a sought boundary in one pass.</summary>
/// <param name="First">Position of the first motion in the path.</param>
/// <param name="Last">Position of the last motion in the path.</param>
public sealed record FoundPass(int First, int Last);
