namespace ErrorMatching.Mating;

/// <summary>What is done about one feature, and why.</summary>
/// <param name="Feature">Name of the feature.</param>
/// <param name="Decision">What is done.</param>
/// <param name="LargestMm">The normal deviation of the largest size among its points, with its sign.</param>
/// <param name="StandardUncertaintyMm">Combined standard uncertainty of a normal deviation of this feature.</param>
/// <param name="Points">The key points in the order of cutting.</param>
public sealed record FeatureDecision(
    string Feature, Decision Decision, double LargestMm, double StandardUncertaintyMm, IReadOnlyList<PointDecision> Points);
