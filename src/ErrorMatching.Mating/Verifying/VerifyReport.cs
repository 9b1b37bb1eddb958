using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The contents of a verification report.</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The input files.</param>
/// <param name="Result">The fit of both counterparts to the part.</param>
/// <param name="Warnings">Warnings for the user, in sentences.</param>
public sealed record VerifyReport(
    ReportJob Job, IReadOnlyList<ReportInput> Inputs, VerificationResult Result, IReadOnlyList<string> Warnings)
{
    /// <summary>True if the counterpart before was measured; false if the designed one is used.</summary>
    public bool IsBeforeMeasured { get; init; } = true;

    /// <summary>The measurement of the counterpart before; null if the designed one is used.</summary>
    public ReportInput? Before => ReportInputs.Find(Inputs, "counterpart");
}
