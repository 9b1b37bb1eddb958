namespace ErrorMatching.Hmi;

/// <summary>What was decided about a feature, as it is shown.</summary>
/// <param name="Feature">The feature and its shape.</param>
/// <param name="Decision">What was decided, in a word or two.</param>
/// <param name="Reason">Why.</param>
/// <param name="Largest">The largest deviation in mm, with its sign: part - counterpart along the normal.</param>
public sealed record DecisionRow(string Feature, string Decision, string Reason, string Largest);
