namespace ErrorMatching.Jobs;

/// <summary>Stored unsaved changes of a job.</summary>
public sealed record StoredDraft
{
    /// <summary>The job's name in the cell.</summary>
    public required string Job { get; init; }

    /// <summary>The user who made them.</summary>
    public required string By { get; init; }

    /// <summary>Time of the last change.</summary>
    public required DateTimeOffset At { get; init; }

    /// <summary>SHA-256 of the job's file that they are based on; empty if there was none.</summary>
    public required string BaseSha256 { get; init; }

    /// <summary>The draft.</summary>
    public required MatingDraft Draft { get; init; }
}
