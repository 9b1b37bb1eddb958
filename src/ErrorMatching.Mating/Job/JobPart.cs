namespace ErrorMatching.Mating;

/// <summary>The files of the cut and measured piece, as the job writes them.</summary>
/// <param name="Theoretical">The key points as designed.</param>
/// <param name="Measured">The same points as measured.</param>
public sealed record JobPart(string Theoretical, string Measured);
