namespace ErrorMatching.Cell;

/// <summary>What is looked for in the history. What is null is not asked about; all that is given must hold.</summary>
public sealed record HistoryQuery
{
    /// <summary>True if a serial number, a work order, a program's name and a user are found by a part of them as well, in capitals or not: what a person types.</summary>
    public bool IsLoose { get; init; }

    /// <summary>Serial number of the piece.</summary>
    public string? Serial { get; init; }

    /// <summary>The work order of the piece, or of its job where the piece says none.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>Arrived at this time or later.</summary>
    public DateTimeOffset? From { get; init; }

    /// <summary>Arrived before this time.</summary>
    public DateTimeOffset? To { get; init; }

    /// <summary>Name of the program at the machine, or SHA-256 of the compensated program or at least its first 8 digits.</summary>
    public string? Program { get; init; }

    /// <summary>Who took any of its steps.</summary>
    public string? User { get; init; }

    /// <summary>How far it has come.</summary>
    public CorrectionState? State { get; init; }

    /// <summary>The machine that its program is for.</summary>
    public string? Machine { get; init; }

    /// <summary>The most that are found: the latest.</summary>
    public int Most { get; init; } = 100;
}
