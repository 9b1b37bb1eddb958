namespace ErrorMatching.Cell;

/// <summary>Whose measurement a file is, or why nobody can tell.</summary>
public sealed record Recognition
{
    /// <summary>Code of a file that no job takes.</summary>
    public const string UnknownPiece = "unknown-piece";

    /// <summary>Code of a file that several jobs take.</summary>
    public const string AmbiguousPiece = "ambiguous-piece";

    /// <summary>Code of a file whose patterns read several serial numbers or work orders.</summary>
    public const string ContradictoryPiece = "contradictory-piece";

    /// <summary>Code of a file whose job cannot be read any more.</summary>
    public const string UnusableJob = "unusable-job";

    /// <summary>The job; null if it is refused.</summary>
    public CellJobSettings? Job { get; init; }

    /// <summary><c>part</c>, <c>counterpart</c> or <c>surface</c>; null if it is refused.</summary>
    public string? Piece { get; init; }

    /// <summary>Serial number of the piece; null if no pattern reads it.</summary>
    public string? Serial { get; init; }

    /// <summary>The work order; null if no pattern reads it.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>Stable word for why it is refused: one of the codes here, or of a measurement that cannot be read; null if it is recognized.</summary>
    public string? Code { get; init; }

    /// <summary>The reason in a setter's words; null if it is recognized.</summary>
    public string? Reason { get; init; }

    internal static Recognition Refused(string code, string reason) => new() { Code = code, Reason = reason };
}
