namespace ErrorMatching.Jobs;

/// <summary>The alignment of measured points, as typed.</summary>
/// <param name="Kind"><c>none</c>, <c>datum</c> or <c>best-fit</c>.</param>
/// <param name="Origin">Label of the datum's origin.</param>
/// <param name="Direction">Label of the point that gives the datum's direction.</param>
/// <param name="LockX">True if a best fit must not shift along the first axis.</param>
/// <param name="LockY">True if a best fit must not shift along the second axis.</param>
/// <param name="LockRotation">True if a best fit must not rotate.</param>
public sealed record AlignmentDraft(
    string Kind = "none", string Origin = "", string Direction = "", bool LockX = false, bool LockY = false, bool LockRotation = false);
