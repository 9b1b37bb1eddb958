namespace ErrorMatching.Cell;

/// <summary>Search criteria for the history. Null criteria are ignored; all others must match.</summary>
public sealed record HistoryQuery
{
    /// <summary>True if part of a serial number, work order, program name or user matches too, in any case: for text that a person
    /// types.</summary>
    public bool IsLoose { get; init; }

    /// <summary>Serial number of the piece.</summary>
    public string? Serial { get; init; }

    /// <summary>The work order of the piece, or of its job if the piece has none.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>Arrived at this time or later.</summary>
    public DateTimeOffset? From { get; init; }

    /// <summary>Arrived before this time.</summary>
    public DateTimeOffset? To { get; init; }

    /// <summary>Name of the program at the machine, or SHA-256 of the compensated program or at least its first 8 digits.</summary>
    public string? Program { get; init; }

    /// <summary>The user who took any of its steps.</summary>
    public string? User { get; init; }

    /// <summary>Its state.</summary>
    public CorrectionState? State { get; init; }

    /// <summary>The machine that its program is for.</summary>
    public string? Machine { get; init; }

    /// <summary>Maximum number of results; the latest are returned.</summary>
    public int Most { get; init; } = 100;
}
