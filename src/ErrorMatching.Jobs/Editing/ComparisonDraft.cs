namespace ErrorMatching.Jobs;

/// <summary>A comparison beside those that every feature has, as it is being typed.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Quantity"><c>angle</c>, <c>deviation</c> or <c>deviation-x</c>.</param>
/// <param name="Of">Two elements of an angle, or labels of points, ranges allowed, with commas between them.</param>
public sealed record ComparisonDraft(string Name = "", string Quantity = "angle", string Of = "");
