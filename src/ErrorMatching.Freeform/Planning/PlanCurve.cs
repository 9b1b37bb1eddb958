namespace ErrorMatching.Freeform;

/// <summary>A measured curve along u with its points.</summary>
/// <param name="V">The fixed parameter.</param>
/// <param name="Reason">The reason for the curve.</param>
/// <param name="Nodes">Its points by ascending u.</param>
internal sealed record PlanCurve(double V, PlanReason Reason, IReadOnlyList<(double U, PlanReason Reason)> Nodes);
