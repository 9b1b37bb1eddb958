using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>The decisions on all features of a job, and the reasons for a refusal.</summary>
/// <param name="Features">The features in the order of cutting, decided even if the job is refused.</param>
/// <param name="Refusals">Why no program may be made; empty if it may.</param>
public sealed record MatingDecision(IReadOnlyList<FeatureDecision> Features, IReadOnlyList<Refusal> Refusals)
{
    /// <summary>True if a program may be made.</summary>
    public bool IsUsable => Refusals.Count == 0;

    /// <summary>True if at least one feature is compensated.</summary>
    public bool Compensates => Features.Any(f => f.Decision == Decision.Compensated);
}
