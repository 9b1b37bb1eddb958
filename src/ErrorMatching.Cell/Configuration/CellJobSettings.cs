namespace ErrorMatching.Cell;

/// <summary>A job of the cell: which files belong to it, and where its programs go.</summary>
public sealed record CellJobSettings
{
    /// <summary>Its name.</summary>
    public required string Name { get; init; }

    /// <summary>The job's file, mating or free-form.</summary>
    public required string File { get; init; }

    /// <summary>The gauges whose files may belong to it.</summary>
    public required IReadOnlyList<string> Gauges { get; init; }

    /// <summary>How its files are recognized, and what they tell about the piece.</summary>
    public required RecognitionSettings Recognize { get; init; }

    /// <summary>True for a free-form job, false for a mating.</summary>
    public bool IsFreeform { get; init; }

    /// <summary>What its files measure: <c>part</c>, <c>counterpart</c> or <c>surface</c>; null if the rules in the job's file decide for
    /// each file.</summary>
    public string? Piece { get; init; }

    /// <summary>The machine.</summary>
    public required string Machine { get; init; }

    /// <summary>The machine's slot.</summary>
    public required string Slot { get; init; }

    /// <summary>True if pieces are processed by serial number instead of in order of arrival.</summary>
    public required bool InOrderOfSerial { get; init; }

    /// <summary>True if each correction starts from the program that cut the measured piece, so that corrections add up; only for
    /// feedback.</summary>
    public required bool Accumulates { get; init; }

    /// <summary>An existing finishing program to displace, for free-form jobs whose tool path comes from a CAM system; else null.</summary>
    public string? Program { get; init; }

    /// <summary>This job's policy, which replaces the cell's; values that the job omits come from the cell. Null if the job sets
    /// none.</summary>
    public PolicySettings? Policy { get; init; }
}

/// <summary>Patterns that recognize a job's files; all that are given must match. The groups <c>serial</c> and <c>workOrder</c> capture the
/// serial number and the work order. Where <c>toolChanged</c> captures anything, the tool was changed before the piece was cut.</summary>
/// <param name="FileName">Pattern for the file name.</param>
/// <param name="HeaderField">A header field and the pattern for its value.</param>
/// <param name="Column">A column and the pattern for all its values.</param>
public sealed record RecognitionSettings(
    string? FileName, (string Name, string Pattern)? HeaderField, (string Name, string Pattern)? Column);
