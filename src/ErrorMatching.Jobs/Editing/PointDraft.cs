namespace ErrorMatching.Jobs;

/// <summary>A theoretical key point, as typed.</summary>
/// <param name="Label">Its label.</param>
/// <param name="X">Coordinate along the first axis, mm.</param>
/// <param name="Y">Coordinate along the second axis, mm.</param>
/// <param name="Z">Coordinate along the third axis, mm; empty for points of a plane.</param>
public sealed record PointDraft(string Label, string X = "", string Y = "", string Z = "");
