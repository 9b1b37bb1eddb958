namespace ErrorMatching.Jobs;

/// <summary>Unsaved changes of a job as they were kept.</summary>
public sealed record KeptDraft
{
    /// <summary>The job's name in the cell.</summary>
    public required string Job { get; init; }

    /// <summary>Who made them.</summary>
    public required string By { get; init; }

    /// <summary>When the last of them was made.</summary>
    public required DateTimeOffset At { get; init; }

    /// <summary>SHA-256 of the job's file that they started from; empty where there was none.</summary>
    public required string BaseSha256 { get; init; }

    /// <summary>The draft.</summary>
    public required MatingDraft Draft { get; init; }
}
