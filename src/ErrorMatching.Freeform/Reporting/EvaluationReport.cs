using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>What a report says of measured pieces, before and after compensation.</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The files that it was made from.</param>
/// <param name="Surface">The nominal surface.</param>
/// <param name="Measured">The pieces asked about.</param>
/// <param name="Before">The pieces before compensation; null if none were given.</param>
public sealed record EvaluationReport(ReportJob Job, IReadOnlyList<ReportInput> Inputs, PartSurface Surface, SurfaceEvaluation Measured, SurfaceEvaluation? Before);
