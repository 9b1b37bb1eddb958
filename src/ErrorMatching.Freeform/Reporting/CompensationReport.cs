using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The content of a compensation report.</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The input files.</param>
/// <param name="Result">The compensation.</param>
/// <param name="ToolPath">The tool path for the compensated surface.</param>
/// <param name="Program">The finishing program's file as written, with its SHA-256.</param>
/// <param name="CalculatingS">Calculation time in seconds, measured by the caller as the core has no clock; null if not measured.</param>
public sealed record CompensationReport(
    ReportJob Job,
    IReadOnlyList<ReportInput> Inputs,
    CompensationResult Result,
    ToolPath ToolPath,
    ReportInput Program,
    double? CalculatingS)
{
    /// <summary>True if the program calls its tool; false if it starts with a stop and an alarm because the job names none.</summary>
    public bool CallsTool { get; init; } = true;

    /// <summary>What everybody must know first: a missing tool call, then the warnings of the compensation.</summary>
    public IReadOnlyList<ReportWarning> Warnings =>
        CallsTool ? Result.Warnings : [ReportWarning.Of(SurfaceWarningForms.NoToolCall), .. Result.Warnings];

    /// <summary>The verdict by the job's profile tolerance, calculated at each call; null if the job states none.</summary>
    public SurfaceVerdict? Verdict => Result.Verdict();

    /// <summary>What became of a program that the verdict says not to cut.</summary>
    public Acceptance Acceptance { get; init; } = Acceptance.None;

    /// <summary>The program that cut the measured piece, if known.</summary>
    public MeasuredPieceProgram CutBy { get; init; } = new(null, null);
}
