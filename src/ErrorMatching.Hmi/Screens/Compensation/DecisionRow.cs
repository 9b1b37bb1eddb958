namespace ErrorMatching.Hmi;

/// <summary>The displayed decision about a feature.</summary>
/// <param name="Feature">The feature and its shape.</param>
/// <param name="Decision">The decision, in a word or two.</param>
/// <param name="Reason">The reason.</param>
/// <param name="LargestName">What the largest deviation is the difference of.</param>
/// <param name="Largest">The largest deviation along the normal in mm, with its sign: of the part, or of part - counterpart.</param>
internal sealed record DecisionRow(string Feature, string Decision, string Reason, string LargestName, string Largest);
