using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>One measured piece with its errors and statistics.</summary>
/// <param name="File">The file of points, as the user named it.</param>
/// <param name="Sha256">SHA-256 of the file's bytes as 64 lowercase hexadecimal digits.</param>
/// <param name="Stage">The stage after which it was measured. Its stock was subtracted from the distances.</param>
/// <param name="StageIsFound">True if the stage was derived from the points because they are closer to its surface than to that of the
/// job's stage.</param>
/// <param name="Alignment">The alignment of the points to the surface; null if they were not moved.</param>
/// <param name="Samples">The error at each point.</param>
/// <param name="Statistics">Statistics of the errors.</param>
/// <param name="Warnings">Harmless irregularities in the file, and points far from their neighbors' prediction, in sentences.</param>
public sealed record EvaluatedPiece(
    string File,
    string Sha256,
    CuttingStage Stage,
    bool StageIsFound,
    SurfaceAlignment? Alignment,
    IReadOnlyList<ErrorSample> Samples,
    DeviationStatistics Statistics,
    IReadOnlyList<ReportWarning> Warnings)
{
    /// <summary>The piece judged by the job's profile tolerance; null if the job states none.</summary>
    public ProfileJudgement? Judgement { get; init; }

    /// <summary>A sentence if the points determined the stage; null if the job's stage was right.</summary>
    public string? StageNote =>
        StageIsFound
            ? $"The points of {File} lie on the surface after {MeasuredStage.Name(Stage)}, not after the stage that the job names: its "
                + $"stock was used."
            : null;
}
