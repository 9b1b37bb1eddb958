using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Everything that a match has to say: what was measured, what was decided, what changed, and what was proved. <c>report.json</c>
/// and <c>report.html</c> are made of it.</summary>
public sealed record MatchReport
{
    /// <summary>The job.</summary>
    public required ReportJob Job { get; init; }

    /// <summary>The files it was made from.</summary>
    public required IReadOnlyList<ReportInput> Inputs { get; init; }

    /// <summary>How each measurement was aligned: the part's, then the counterpart's where it was used.</summary>
    public required IReadOnlyList<ReportAlignment> Alignments { get; init; }

    /// <summary>The check of the origin; null if the job asks for none.</summary>
    public OriginCheck? OriginCheck { get; init; }

    /// <summary>What the job asked to be made of the deviations.</summary>
    public required JobCompensation Compensation { get; init; }

    /// <summary>The gauge's uncertainty and what it is made of.</summary>
    public required UncertaintyBudget Uncertainty { get; init; }

    /// <summary>The tolerance chain; null if the job has none.</summary>
    public ToleranceChain? Chain { get; init; }

    /// <summary>The features in the order of cutting.</summary>
    public required IReadOnlyList<ReportFeature> Features { get; init; }

    /// <summary>The key points in the order of cutting.</summary>
    public required IReadOnlyList<ReportKeyPoint> KeyPoints { get; init; }

    /// <summary>The key points that the program is predicted to leave outside of their limits.</summary>
    public OutsideLimits Outside => OutsideOf(KeyPoints);

    /// <summary>The program that was written.</summary>
    public required ReportProgram Program { get; init; }

    /// <summary>What was shown about it.</summary>
    public required ReportProof Proof { get; init; }

    /// <summary>How long it took.</summary>
    public required ReportTime Time { get; init; }

    /// <summary>The tool-radius wear value that would do the same as the whole correction (<see cref="UniformOffset"/>);
    /// null if none would.</summary>
    public double? RadiusWearMm { get; init; }

    /// <summary>What a person should know before using the program, in sentences.</summary>
    public IReadOnlyList<ReportWarning> Warnings { get; init; } = [];

    /// <summary>What a person may want to know besides.</summary>
    public IReadOnlyList<string> Notes { get; init; } = [];

    /// <summary>Those of some key points that the program is predicted to leave outside of their limits.</summary>
    internal OutsideLimits OutsideOf(IEnumerable<ReportKeyPoint> points) =>
        OutsideLimits.Of(points.Select(
            p => (p.Point, Features.FirstOrDefault(f => f.Name == p.Feature)?.Tolerance.Band.OfMatingError, -p.DecidedMm, p.PredictedMm)));
}
