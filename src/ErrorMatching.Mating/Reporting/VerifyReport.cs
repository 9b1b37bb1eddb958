using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Everything that a verification has to say.</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The files it was made from.</param>
/// <param name="Result">How well both counterparts fit the part.</param>
/// <param name="Warnings">What a person should know, in sentences.</param>
public sealed record VerifyReport(
    ReportJob Job, IReadOnlyList<ReportInput> Inputs, VerificationResult Result, IReadOnlyList<string> Warnings)
{
    /// <summary>True if the counterpart before was measured, false if it is taken as designed.</summary>
    public bool IsBeforeMeasured { get; init; } = true;

    /// <summary>The boundaries of the features, for plots and drawings.</summary>
    public IReadOnlyList<VerifiedBoundary> Boundaries { get; init; } = [];
}
