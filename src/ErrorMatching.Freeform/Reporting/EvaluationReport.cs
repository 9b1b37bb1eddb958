using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The content of an evaluation report: measured pieces before and after compensation, compared with pieces compensated by tool
/// radius (tables 2 to 4 of Lee 2019).</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The input files.</param>
/// <param name="Surface">The nominal surface.</param>
/// <param name="Measured">The evaluated pieces.</param>
/// <param name="Before">The pieces before compensation; null if none were given.</param>
/// <param name="ToolRadius">Pieces of the design that were compensated by tool radius instead; null if none were given.</param>
/// <param name="ToolRadiusBefore">Those before compensation; null if none were given.</param>
public sealed record EvaluationReport(
    ReportJob Job,
    IReadOnlyList<ReportInput> Inputs,
    PartSurface Surface,
    SurfaceEvaluation Measured,
    SurfaceEvaluation? Before,
    SurfaceEvaluation? ToolRadius = null,
    SurfaceEvaluation? ToolRadiusBefore = null)
{
    /// <summary>The tolerance that the pieces are judged by; null if the job states none.</summary>
    public ProfileTolerance? Tolerance { get; init; }

    /// <summary>True if all measured pieces are in tolerance; null if the job states none.</summary>
    public bool? IsInTolerance => Tolerance is null ? null : Measured.Pieces.All(p => p.Judgement!.IsWithin);

    /// <summary>Reduction of standard deviation and profile; null if there is nothing to compare.</summary>
    public SurfaceImprovement? Improvement => SurfaceImprovement.Of(Before, Measured);

    /// <summary>The same for the pieces that were compensated by tool radius.</summary>
    public SurfaceImprovement? ToolRadiusImprovement => SurfaceImprovement.Of(ToolRadiusBefore, ToolRadius);

    /// <summary>All pieces, in the order of reading.</summary>
    public IEnumerable<EvaluatedPiece> Pieces => Parts.SelectMany(p => p.Evaluation.Pieces);

    /// <summary>All evaluations with their names, in the order of reading.</summary>
    internal IEnumerable<(string Name, SurfaceEvaluation Evaluation)> Parts
    {
        get
        {
            (string Name, SurfaceEvaluation? Evaluation)[] all =
                [
                    ("Before", Before),
                    (Before is null ? "Measured" : "After", Measured),
                    ("Tool radius, before", ToolRadiusBefore),
                    (ToolRadiusBefore is null ? "Tool radius" : "Tool radius, after", ToolRadius)];
            return all.Where(p => p.Evaluation is not null).Select(p => (p.Name, p.Evaluation!));
        }
    }
}
