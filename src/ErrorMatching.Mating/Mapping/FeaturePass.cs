namespace ErrorMatching.Mating;

/// <summary>One uninterrupted cut along a feature: consecutive motions in its plane. A feature that is cut at several depths has several.</summary>
/// <param name="First">Position of the first motion in the path.</param>
/// <param name="Last">Position of the last motion in the path.</param>
/// <param name="Starts">Length of the pass before each of its motions, and at its end.</param>
/// <param name="Feet">The feature's key points, in the order of the job.</param>
public sealed record FeaturePass(int First, int Last, IReadOnlyList<double> Starts, IReadOnlyList<KeyPointFoot> Feet);
