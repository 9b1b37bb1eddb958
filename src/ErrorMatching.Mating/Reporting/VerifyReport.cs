using ErrorMatching.Geometry;
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

    /// <summary>Standard uncertainty of a mating error along its normal, which two measurements make; null in reports of earlier
    /// versions.</summary>
    public double? UncertaintyMm { get; init; }

    /// <summary>The two measured pieces, assembled; null if their outline does not tell, and in reports of earlier versions.</summary>
    public PairAssembly? Pair { get; init; }

    /// <summary>The rule by which points are accepted near their limits; null in reports of earlier versions.</summary>
    public DecisionRule? Rule { get; init; }

    /// <summary>The verdict on the counterpart that was cut with compensation.</summary>
    public VerifyVerdict Verdict => VerifyVerdict.Judge(this);

    /// <summary>The measurement of the counterpart before; null if the designed one is used.</summary>
    public ReportInput? Before => ReportInputs.Find(Inputs, "counterpart");
}
