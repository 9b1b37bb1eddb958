namespace ErrorMatching.Freeform;

/// <summary>Which program cut the measured piece. A compensation starts from the nominal surface, so it must have been a nominal one.</summary>
/// <param name="File">The program that was named and carries no marker; null if none was named, and a nominal one is taken for granted.</param>
/// <param name="Sha256">SHA-256 of it; null if none was named.</param>
public sealed record MeasuredPieceProgram(string? File, string? Sha256)
{
    /// <summary>A sentence for people.</summary>
    public string Sentence => File is null
        ? "A nominal program is taken to have cut it: none was named (cutBy, --cut-by)."
        : $"{File}, which follows no measurement.";
}
