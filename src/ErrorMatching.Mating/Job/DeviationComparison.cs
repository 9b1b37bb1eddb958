namespace ErrorMatching.Mating;

/// <summary>The largest deviation of some key points.</summary>
/// <param name="Name">Its name.</param>
/// <param name="AlongX">True for deviations along the first axis, as in the paper; false for deviations along the normals.</param>
/// <param name="Points">Labels of at least one key point.</param>
public sealed record DeviationComparison(string Name, bool AlongX, IReadOnlyList<string> Points) : JobComparison(Name);
