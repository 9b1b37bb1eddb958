namespace ErrorMatching.Mating;

/// <summary>One dimension of a tolerance chain.</summary>
/// <param name="Name">What it measures.</param>
/// <param name="NominalMm">Its nominal size.</param>
/// <param name="Tolerance">The limits of its deviation from nominal.</param>
/// <param name="Sign">1 if a larger dimension lengthens the chain, -1 if it shortens it.</param>
public sealed record ChainLink(string Name, double NominalMm, ToleranceBand Tolerance, int Sign);
