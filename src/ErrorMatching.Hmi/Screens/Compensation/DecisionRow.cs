namespace ErrorMatching.Hmi;

/// <summary>The displayed decision about a feature.</summary>
/// <param name="Feature">The feature and its shape.</param>
/// <param name="Decision">The decision, in a word or two.</param>
/// <param name="Reason">The reason.</param>
/// <param name="Largest">The largest deviation in mm, with its sign: part - counterpart along the normal.</param>
internal sealed record DecisionRow(string Feature, string Decision, string Reason, string Largest);
