namespace ErrorMatching.Mating;

/// <summary>One cause of uncertainty of a measured coordinate.</summary>
/// <param name="Name">The cause.</param>
/// <param name="ValueMm">Its standard uncertainty, zero or more.</param>
public sealed record UncertaintyContribution(string Name, double ValueMm);
