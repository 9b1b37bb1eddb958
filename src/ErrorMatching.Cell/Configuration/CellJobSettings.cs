namespace ErrorMatching.Cell;

/// <summary>A job of the cell: which files are its, and where its programs go.</summary>
public sealed record CellJobSettings
{
    /// <summary>What people call it.</summary>
    public required string Name { get; init; }

    /// <summary>The job's file, mating or free-form.</summary>
    public required string File { get; init; }

    /// <summary>The gauges whose files may be its.</summary>
    public required IReadOnlyList<string> Gauges { get; init; }

    /// <summary>How its files are told from others, and what they say about the piece.</summary>
    public required RecognitionSettings Recognize { get; init; }

    /// <summary>True for a free-form job, false for a mating.</summary>
    public bool IsFreeform { get; init; }

    /// <summary>What its files measure: <c>part</c>, <c>counterpart</c> or <c>surface</c>; null if the rules in the job's file decide for each file.</summary>
    public string? Piece { get; init; }

    /// <summary>The machine.</summary>
    public required string Machine { get; init; }

    /// <summary>The machine's slot.</summary>
    public required string Slot { get; init; }

    /// <summary>True if pieces go by serial number instead of arrival.</summary>
    public required bool InOrderOfSerial { get; init; }

    /// <summary>True if each correction starts from the program that cut the measured piece, so that corrections add up; only for feedback.</summary>
    public required bool Accumulates { get; init; }

    /// <summary>An existing finishing program that is displaced, for free-form jobs whose tool path comes from a CAM; else null.</summary>
    public string? Program { get; init; }

    /// <summary>What holds for this job instead of the cell's policy, with the cell's in what the job leaves out; null if nothing does.</summary>
    public PolicySettings? Policy { get; init; }
}
