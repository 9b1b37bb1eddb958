namespace ErrorMatching.Mating;

/// <summary>The largest deviation of some key points.</summary>
/// <param name="Name">Its name.</param>
/// <param name="AlongX">True if deviations are taken along the first axis, as the paper does; false if along the normals.</param>
/// <param name="Points">Labels of at least one key point.</param>
public sealed record DeviationComparison(string Name, bool AlongX, IReadOnlyList<string> Points) : JobComparison(Name);
