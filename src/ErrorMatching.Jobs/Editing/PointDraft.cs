namespace ErrorMatching.Jobs;

/// <summary>A theoretical key point as it is being typed.</summary>
/// <param name="Label">Its label.</param>
/// <param name="X">Along the first axis, mm, as typed.</param>
/// <param name="Y">Along the second axis, mm, as typed.</param>
/// <param name="Z">Along the third axis, mm, as typed; empty for points of a plane.</param>
public sealed record PointDraft(string Label, string X = "", string Y = "", string Z = "");
