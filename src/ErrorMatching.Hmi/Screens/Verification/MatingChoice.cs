namespace ErrorMatching.Hmi;

/// <summary>A mating whose pieces can be looked at.</summary>
/// <param name="Name">What people call it: the name of the first of the cell's jobs with its file.</param>
/// <param name="Jobs">The cell's jobs with its file: those of parts and those of counterparts.</param>
public sealed record MatingChoice(string Name, IReadOnlyList<string> Jobs);
