using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>The inputs of a correction, except for the job's own files.</summary>
public sealed record CorrectionRequest
{
    /// <summary>The cell's job.</summary>
    public required CellJobSettings Job { get; init; }

    /// <summary>The measured piece: <c>part</c>, <c>counterpart</c> or <c>surface</c>.</summary>
    public required string Piece { get; init; }

    /// <summary>The measurement.</summary>
    public required StoredFile Measurement { get; init; }

    /// <summary>The part's measurement, for a counterpart that is compared with it; null while there is none.</summary>
    public StoredFile? Part { get; init; }

    /// <summary>If the job accumulates: the program that cut the measured counterpart; null for the original one.</summary>
    public ReadOnlyMemory<byte>? Base { get; init; }

    /// <summary>If the job accumulates: the sums of all corrections from the original program to <see cref="Base"/>.</summary>
    public CorrectionSums Sums { get; init; } = CorrectionSums.None;

    /// <summary>For a surface: the last program sent, which may have cut the measured piece; null if none was sent.</summary>
    public StoredFile? LastSent { get; init; }

    /// <summary>If the job accumulates: the report of the correction whose program cut the measured piece; null if a nominal program
    /// did.</summary>
    public StoredFile? Previous { get; init; }

    /// <summary>If the job accumulates: true if the tool was changed before the measured piece was cut.</summary>
    public bool ToolChanged { get; init; }

    /// <summary>Name of the program of the job's slot, by which a program of offsets can be called; null if it is not known.</summary>
    public string? SlotProgram { get; init; }

    /// <summary>The correction's identity from recognition; null if it has none yet. If the final identity differs, the correction is
    /// refused: the job's files have changed.</summary>
    public string? Identity { get; init; }
}

/// <summary>A file that the cell stores, held in memory: it is not read from disk again.</summary>
/// <param name="Name">Its name on arrival, without folders.</param>
/// <param name="Bytes">Its content.</param>
public sealed record StoredFile(string Name, ReadOnlyMemory<byte> Bytes)
{
    /// <summary>SHA-256 of its content as 64 lower-case hexadecimal digits.</summary>
    public string Sha256 => ContentHash.Sha256(Bytes.Span);
}
