using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>The stored report of a compensated surface, with a generated or a displaced program.</summary>
/// <param name="JobName">Name of the job.</param>
/// <param name="Findings">What was measured, compensated and predicted.</param>
/// <param name="ToolPath">The generated tool path; null if an existing program was displaced.</param>
/// <param name="Proof">The proof of the displaced program; null if the program was generated.</param>
/// <param name="CallsTool">True if the program calls its tool, false if it stops with an alarm instead; null if the report does not say,
/// because it is old or an existing program was displaced.</param>
/// <param name="Warnings">What the user should know before using the program. A missing tool call is reported by
/// <paramref name="CallsTool"/>.</param>
internal sealed record StoredSurface(
    string JobName,
    SurfaceFindings Findings,
    ToolPathFigures? ToolPath,
    ReportProof? Proof,
    bool? CallsTool,
    IReadOnlyList<ReportWarning> Warnings)
{
    /// <summary>A surface with a generated program; null if the document is too old.</summary>
    internal static StoredSurface? Of(CompensationDocument? document) => document is null ? null : new(
        document.Job.Name,
        document.Findings,
        document.ToolPath,
        null,
        document.CallsTool,
        // A missing tool call is the first warning.
        [.. document.Warnings.Skip(document.CallsTool == false ? 1 : 0)]);

    /// <summary>A surface with a displaced program; null if the document is too old.</summary>
    internal static StoredSurface? Of(DisplacementDocument? document) =>
        document is null ? null : new(document.JobName, document.Findings, null, document.Proof, null, document.Warnings);
}
