namespace ErrorMatching.Mating;

/// <summary>What is done about all features of a job, or why nothing may be done.</summary>
/// <param name="Features">The features in the order of cutting, decided also where the job is refused.</param>
/// <param name="Refusals">Why no program may be made; empty if one may.</param>
public sealed record MatingDecision(IReadOnlyList<FeatureDecision> Features, IReadOnlyList<MatingRefusal> Refusals)
{
    /// <summary>True if a program may be made of it.</summary>
    public bool IsUsable => Refusals.Count == 0;

    /// <summary>True if at least one feature is compensated.</summary>
    public bool Compensates => Features.Any(f => f.Decision == Decision.Compensated);
}
