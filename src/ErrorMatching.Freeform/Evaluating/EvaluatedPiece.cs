namespace ErrorMatching.Freeform;

/// <summary>One measured piece and what its errors come to.</summary>
/// <param name="File">The file of its points, as the user named it.</param>
/// <param name="Sha256">SHA-256 of the file's bytes as 64 lower-case hexadecimal digits.</param>
/// <param name="Stage">The stage after which it was measured: its stock was taken off the distances.</param>
/// <param name="StageIsFound">True if the points said so, because they lie closer to that stage's surface than to the one the job names.</param>
/// <param name="Alignment">How the points were laid onto the surface; null if they stayed where they were measured.</param>
/// <param name="Samples">The errors, by point.</param>
/// <param name="Statistics">What they come to.</param>
/// <param name="Warnings">What is strange in the file and does no harm, and points that are far from what those around them say, in sentences.</param>
public sealed record EvaluatedPiece(
    string File,
    string Sha256,
    CuttingStage Stage,
    bool StageIsFound,
    SurfaceAlignment? Alignment,
    IReadOnlyList<ErrorSample> Samples,
    DeviationStatistics Statistics,
    IReadOnlyList<string> Warnings)
{
    /// <summary>That the points said after which stage they were measured, in a sentence; null if the job was right.</summary>
    public string? StageNote => StageIsFound ? $"The points of {File} lie on the surface after {MeasuredStage.Name(Stage)}, not after the stage that the job names: its stock was used." : null;
}
