namespace ErrorMatching.Mating;

/// <summary>One dimension of a tolerance chain.</summary>
/// <param name="Name">What it measures.</param>
/// <param name="NominalMm">Its nominal size.</param>
/// <param name="Tolerance">The limits of its deviation from nominal.</param>
/// <param name="Sign">1 where a larger dimension makes the chain longer, -1 where it makes it shorter.</param>
public sealed record ChainLink(string Name, double NominalMm, ToleranceBand Tolerance, int Sign);
