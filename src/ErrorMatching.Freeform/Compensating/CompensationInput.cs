namespace ErrorMatching.Freeform;

/// <summary>What a compensation is made of.</summary>
/// <param name="Job">The job.</param>
/// <param name="Surface">The nominal surface.</param>
/// <param name="Plan">The measuring plan that the points were measured by.</param>
/// <param name="Measured">The measured piece: several files if it was measured several times.</param>
public sealed record CompensationInput(FreeformJob Job, PartSurface Surface, MeasuringPlan Plan, IReadOnlyList<MeasuredPoints> Measured);
