namespace ErrorMatching.Cell;

/// <summary>What a correction is computed from, beside the job's own files.</summary>
public sealed record CorrectionRequest
{
    /// <summary>The cell's job.</summary>
    public required CellJobSettings Job { get; init; }

    /// <summary>What is measured: <c>part</c>, <c>counterpart</c> or <c>surface</c>.</summary>
    public required string Piece { get; init; }

    /// <summary>The measurement.</summary>
    public required KeptFile Measurement { get; init; }

    /// <summary>The part's measurement, for a counterpart that is compared with it; null while there is none.</summary>
    public KeptFile? Part { get; init; }

    /// <summary>Where the job accumulates: the program that cut the measured counterpart; null for the original one.</summary>
    public ReadOnlyMemory<byte>? Base { get; init; }

    /// <summary>Where the job accumulates: the sums of all corrections that led from the original program to <see cref="Base"/>.</summary>
    public CorrectionSums Sums { get; init; } = CorrectionSums.None;

    /// <summary>Of a surface: the program that was sent last, which may have cut the measured piece; null while none was sent.</summary>
    public KeptFile? LastSent { get; init; }

    /// <summary>The identity that the correction was recognized by; null if it has none yet. Another one at the end refuses it: the job's files were changed meanwhile.</summary>
    public string? Identity { get; init; }
}
