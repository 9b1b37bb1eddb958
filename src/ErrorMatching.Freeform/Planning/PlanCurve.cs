namespace ErrorMatching.Freeform;

/// <summary>A curve along u that is measured, with its points.</summary>
/// <param name="V">The parameter that stays.</param>
/// <param name="Reason">Why there is a curve here.</param>
/// <param name="Nodes">Its points by rising u.</param>
internal sealed record PlanCurve(double V, PlanReason Reason, IReadOnlyList<(double U, PlanReason Reason)> Nodes);
