namespace ErrorMatching.Mating;

/// <summary>A straight element of a feature, whose direction a job may compare.</summary>
/// <param name="Points">The labels of its key points in the order of cutting.</param>
/// <param name="Method">How a line is fitted to them.</param>
internal sealed record StraightElement(IReadOnlyList<string> Points, LineMethod Method);
