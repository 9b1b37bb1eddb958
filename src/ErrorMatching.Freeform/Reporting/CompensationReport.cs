using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>What a report says of a compensation.</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The files that it was made from.</param>
/// <param name="Result">The compensation.</param>
/// <param name="ToolPath">The path that cuts its surface.</param>
/// <param name="Program">The finishing program's file as it was written, and its SHA-256.</param>
/// <param name="CalculatingS">How long it took, in seconds, for the core has no clock; null if nobody timed it.</param>
public sealed record CompensationReport(ReportJob Job, IReadOnlyList<ReportInput> Inputs, CompensationResult Result, ToolPath ToolPath, ReportInput Program, double? CalculatingS)
{
    /// <summary>True if the program calls its tool; false if it begins with a stop and an alarm, because the job names none.</summary>
    public bool CallsTool { get; init; } = true;

    /// <summary>Which program cut the measured piece, as far as anybody said.</summary>
    public MeasuredPieceProgram CutBy { get; init; } = new(null, null);
}
