namespace ErrorMatching.Mating;

/// <summary>A match, or the reasons why no program may be made.</summary>
/// <param name="Result">The match; null if refused.</param>
/// <param name="Refusals">The reasons; empty if there is a result.</param>
public sealed record MatchOutcome(MatchResult? Result, IReadOnlyList<MatingRefusal> Refusals)
{
    internal static MatchOutcome Refused(params IReadOnlyList<MatingRefusal> refusals) => new(null, refusals);
}
