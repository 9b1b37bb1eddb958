namespace ErrorMatching.Jobs;

/// <summary>A comparison in addition to those that every feature has, as typed.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Quantity"><c>angle</c>, <c>deviation</c> or <c>deviation-x</c>.</param>
/// <param name="Of">Two elements of an angle, or point labels, separated by commas; ranges are allowed.</param>
public sealed record ComparisonDraft(string Name = "", string Quantity = "angle", string Of = "");
