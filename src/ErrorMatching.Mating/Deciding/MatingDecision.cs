using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>The decisions on all features of a job, and the reasons for a refusal.</summary>
/// <param name="Features">The features in the order of cutting, decided even if the job is refused.</param>
/// <param name="Refusals">Why no program may be made; empty if it may.</param>
public sealed record MatingDecision(IReadOnlyList<FeatureDecision> Features, IReadOnlyList<Refusal> Refusals)
{
    /// <summary>True if a program may be made.</summary>
    public bool IsUsable => Refusals.Count == 0;

    /// <summary>The rule by which points are accepted near their limits.</summary>
    public DecisionRule Rule { get; init; } = DecisionRule.Simple;

    /// <summary>The probability that every point of the pair is within its limits without compensation, if the errors of the points are
    /// independent; null if no feature has limits with a width.</summary>
    public double? ProbabilityBefore => Conformance.OfIndependent(Features.Select(f => f.ProbabilityBefore));

    /// <summary>True if at least one feature is compensated.</summary>
    public bool Compensates => Features.Any(f => f.Decision == Decision.Compensated);
}

/// <summary>The decision on one feature, and the numbers behind it.</summary>
/// <param name="Feature">Name of the feature.</param>
/// <param name="Decision">The decision.</param>
/// <param name="LargestMm">The signed normal deviation with the largest magnitude among its points.</param>
/// <param name="StandardUncertaintyMm">Combined standard uncertainty of a normal deviation of this feature.</param>
/// <param name="Points">The key points in the order of cutting.</param>
public sealed record FeatureDecision(
    string Feature, Decision Decision, double LargestMm, double StandardUncertaintyMm, IReadOnlyList<PointDecision> Points)
{
    /// <summary>The limits up to which a deviation is accepted: those of the tolerance, less the guard bands if the job has a rule with
    /// them.</summary>
    public required ToleranceBand Acceptance { get; init; }

    /// <summary>A deviation up to this size may be the gauge's; a larger one is significant. It is the same for all features of a
    /// job.</summary>
    public required double SignificantMm { get; init; }

    /// <summary>True if no point alone is significant, but what they have in common is: a shift, a tilt or a growth of this feature, or of
    /// all features together.</summary>
    public bool IsSignificantTogether { get; init; }

    /// <summary>The probability that every point is within its limits without compensation, if the errors of the points are independent;
    /// null for limits without width.</summary>
    public double? ProbabilityBefore => Conformance.OfIndependent(Points.Select(p => p.ProbabilityBefore));
}

/// <summary>The effect of a decision at one key point.</summary>
/// <param name="Point">The key point.</param>
/// <param name="ExcessMm">Signed part of its normal deviation beyond the acceptance limit; zero inside.</param>
/// <param name="Correction">Displacement of the boundary there, in the part's frame, gain included; zero if the feature is not
/// compensated.</param>
public sealed record PointDecision(BoundaryPoint Point, double ExcessMm, Vector2 Correction)
{
    /// <summary>The probability that the point is within its limits without compensation; null for limits without width.</summary>
    public double? ProbabilityBefore { get; init; }

    /// <summary>The share of <see cref="BoundaryPoint.FollowedMm"/> that is compensated, gain included; 0 if the feature is not
    /// compensated.</summary>
    internal double Share { get; init; }

    /// <summary>The share of what the program does differently from the theoretical outline that is corrected: <see cref="Share"/>, or 0
    /// if the job keeps it.</summary>
    internal double BaseShare { get; init; }

    /// <summary>Signed length of the correction along the point's normal.</summary>
    public double CorrectionNormalMm => Correction.Dot(Point.Normal);
}

/// <summary>The decision on a whole feature.</summary>
public enum Decision
{
    /// <summary>Every point is within the acceptance limits; nothing is compensated.</summary>
    WithinTolerance,

    /// <summary>A point is outside the acceptance limits, but no such deviation is significant: reported, not compensated.</summary>
    NotSignificant,

    /// <summary>The counterpart's boundary is displaced.</summary>
    Compensated,
}
