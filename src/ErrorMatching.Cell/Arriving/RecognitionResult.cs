namespace ErrorMatching.Cell;

/// <summary>Which job and piece a file belongs to, or why that cannot be decided.</summary>
public sealed record RecognitionResult
{
    /// <summary>Code of a file that no job takes.</summary>
    public const string UnknownPiece = "unknown-piece";

    /// <summary>Code of a file that several jobs take.</summary>
    public const string AmbiguousPiece = "ambiguous-piece";

    /// <summary>Code of a file whose patterns capture several serial numbers or work orders.</summary>
    public const string ContradictoryPiece = "contradictory-piece";

    /// <summary>Code of a file whose job can no longer be read.</summary>
    public const string UnusableJob = "unusable-job";

    /// <summary>Code of a file that exceeds the gauge's size limit.</summary>
    public const string TooLarge = "file-too-large";

    /// <summary>The job; null if the file is refused.</summary>
    public CellJobSettings? Job { get; init; }

    /// <summary><c>part</c>, <c>counterpart</c> or <c>surface</c>; null if the file is refused.</summary>
    public string? Piece { get; init; }

    /// <summary>Serial number of the piece; null if no pattern captures it.</summary>
    public string? Serial { get; init; }

    /// <summary>The work order; null if no pattern captures it.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>Stable code for why the file is refused: one of the codes here, or the code of a measurement that cannot be read. Null if
    /// it is recognized.</summary>
    public string? Code { get; init; }

    /// <summary>The reason in a setter's terms; null if the file is recognized.</summary>
    public string? Reason { get; init; }

    internal static RecognitionResult Refused(string code, string reason) => new() { Code = code, Reason = reason };
}
