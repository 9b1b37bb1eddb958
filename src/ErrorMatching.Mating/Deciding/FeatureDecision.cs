namespace ErrorMatching.Mating;

/// <summary>The decision on one feature, and the numbers behind it.</summary>
/// <param name="Feature">Name of the feature.</param>
/// <param name="Decision">The decision.</param>
/// <param name="LargestMm">The signed normal deviation with the largest magnitude among its points.</param>
/// <param name="StandardUncertaintyMm">Combined standard uncertainty of a normal deviation of this feature.</param>
/// <param name="Points">The key points in the order of cutting.</param>
public sealed record FeatureDecision(
    string Feature, Decision Decision, double LargestMm, double StandardUncertaintyMm, IReadOnlyList<PointDecision> Points);
