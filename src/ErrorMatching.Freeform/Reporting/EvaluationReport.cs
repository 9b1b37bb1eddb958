using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>What a report says of measured pieces, before and after compensation, and of pieces that were compensated by tool radius beside them (tables 2 to 4 of Lee 2019).</summary>
/// <param name="Job">The job.</param>
/// <param name="Inputs">The files that it was made from.</param>
/// <param name="Surface">The nominal surface.</param>
/// <param name="Measured">The pieces asked about.</param>
/// <param name="Before">The pieces before compensation; null if none were given.</param>
/// <param name="ToolRadius">Pieces of the design that were compensated by tool radius instead; null if none were given.</param>
/// <param name="ToolRadiusBefore">Those before compensation; null if none were given.</param>
public sealed record EvaluationReport(ReportJob Job, IReadOnlyList<ReportInput> Inputs, PartSurface Surface, SurfaceEvaluation Measured, SurfaceEvaluation? Before, SurfaceEvaluation? ToolRadius = null, SurfaceEvaluation? ToolRadiusBefore = null)
{
    /// <summary>By how much standard deviation and profile became smaller, null where there is nothing to compare with.</summary>
    public SurfaceImprovement? Improvement => SurfaceImprovement.Of(Before, Measured);

    /// <summary>The same of the pieces that were compensated by tool radius.</summary>
    public SurfaceImprovement? ToolRadiusImprovement => SurfaceImprovement.Of(ToolRadiusBefore, ToolRadius);

    /// <summary>All pieces, in the order of reading.</summary>
    public IEnumerable<EvaluatedPiece> Pieces => Parts.SelectMany(p => p.Evaluation.Pieces);

    /// <summary>All that is evaluated, in the order of reading: each with its name.</summary>
    internal IEnumerable<(string Name, SurfaceEvaluation Evaluation)> Parts
    {
        get
        {
            (string Name, SurfaceEvaluation? Evaluation)[] all =
                [("Before", Before), (Before is null ? "Measured" : "After", Measured), ("Tool radius, before", ToolRadiusBefore), (ToolRadiusBefore is null ? "Tool radius" : "Tool radius, after", ToolRadius)];
            return all.Where(p => p.Evaluation is not null).Select(p => (p.Name, p.Evaluation!));
        }
    }
}
