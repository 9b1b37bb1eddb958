namespace ErrorMatching.Freeform;

/// <summary>The inputs of a compensation.</summary>
/// <param name="Job">The job.</param>
/// <param name="Surface">The nominal surface.</param>
/// <param name="Plan">The measuring plan used for the measurement.</param>
/// <param name="Measured">The measured piece: one file per measurement.</param>
public sealed record CompensationInput(FreeformJob Job, PartSurface Surface, MeasuringPlan Plan, IReadOnlyList<MeasuredPoints> Measured);
