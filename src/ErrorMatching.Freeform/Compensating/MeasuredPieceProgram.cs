namespace ErrorMatching.Freeform;

/// <summary>The program that cut the measured piece. A compensation starts from the nominal surface, so it must be nominal.</summary>
/// <param name="File">The named program, which carries no marker; null if none was named, and a nominal one is assumed.</param>
/// <param name="Sha256">SHA-256 of the program; null if none was named.</param>
public sealed record MeasuredPieceProgram(string? File, string? Sha256)
{
    /// <summary>The report of the compensation whose program cut the piece, as given by the caller; null if a nominal one did.</summary>
    public string? Previous { get; init; }

    /// <summary>A sentence for the report.</summary>
    public string Sentence => Previous is not null
        ? $"{File ?? "The program of the compensation before"} cut it, with the corrections that {Previous} states."
        : File is null
        ? "A nominal program is taken to have cut it: none was named (cutBy, --cut-by)."
        : $"{File}, which follows no measurement.";
}
