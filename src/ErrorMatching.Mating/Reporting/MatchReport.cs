using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The contents of a match report: what was measured, decided, changed and proved. Source of <c>report.json</c> and
/// <c>report.html</c>.</summary>
public sealed record MatchReport
{
    /// <summary>The job.</summary>
    public required ReportJob Job { get; init; }

    /// <summary>The input files.</summary>
    public required IReadOnlyList<ReportInput> Inputs { get; init; }

    /// <summary>The alignment of each measurement: the part's, then the counterpart's if it was used.</summary>
    public required IReadOnlyList<ReportAlignment> Alignments { get; init; }

    /// <summary>The check of the origin; null if the job has none.</summary>
    public OriginCheck? OriginCheck { get; init; }

    /// <summary>The compensation that the job requests.</summary>
    public required JobCompensation Compensation { get; init; }

    /// <summary>The gauge's uncertainty and its contributions.</summary>
    public required UncertaintyBudget Uncertainty { get; init; }

    /// <summary>The tolerance chain; null if the job has none.</summary>
    public ToleranceChain? Chain { get; init; }

    /// <summary>The features in the order of cutting.</summary>
    public required IReadOnlyList<ReportFeature> Features { get; init; }

    /// <summary>The key points in the order of cutting.</summary>
    public required IReadOnlyList<ReportKeyPoint> KeyPoints { get; init; }

    /// <summary>The key points that the program is predicted to leave outside their limits.</summary>
    public OutsideLimits Outside => OutsideOf(KeyPoints);

    /// <summary>The program that was written.</summary>
    public required ReportProgram Program { get; init; }

    /// <summary>The proof of that program.</summary>
    public required ReportProof Proof { get; init; }

    /// <summary>The times.</summary>
    public required ReportTime Time { get; init; }

    /// <summary>The tool-radius wear value equivalent to the whole correction (<see cref="UniformOffset"/>), or null.</summary>
    public double? RadiusWearMm { get; init; }

    /// <summary>Warnings to read before using the program, in sentences.</summary>
    public IReadOnlyList<ReportWarning> Warnings { get; init; } = [];

    /// <summary>Additional information.</summary>
    public IReadOnlyList<string> Notes { get; init; } = [];

    /// <summary>The given key points that the program is predicted to leave outside their limits.</summary>
    internal OutsideLimits OutsideOf(IEnumerable<ReportKeyPoint> points) =>
        OutsideLimits.Of(points.Select(
            p => (p.Point, Features.FirstOrDefault(f => f.Name == p.Feature)?.Tolerance.Band.OfMatingError, -p.DecidedMm, p.PredictedMm)));
}
