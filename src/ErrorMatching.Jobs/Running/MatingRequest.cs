using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>Inputs of a mating run in addition to the job.</summary>
public sealed record MatingRequest
{
    /// <summary>The nominal key points; null for the job's.</summary>
    public GivenFile? Theoretical { get; init; }

    /// <summary>The measured part; null for the job's.</summary>
    public GivenFile? Part { get; init; }

    /// <summary>The measured counterpart; null for the job's, which only feedback needs.</summary>
    public GivenFile? Counterpart { get; init; }

    /// <summary>The counterpart's program; null for the job's.</summary>
    public GivenFile? Program { get; init; }

    /// <summary>In feedback, the report of the match whose program cut the measured counterpart: its lot goes on. Null if there is
    /// none.</summary>
    public GivenFile? Previous { get; init; }

    /// <summary>In feedback, the report of the last match of the lot, if other counterparts were measured since
    /// <see cref="Previous"/>.</summary>
    public GivenFile? Latest { get; init; }

    /// <summary>True if the tool was changed before the measured counterpart was cut; only with <see cref="Previous"/> or
    /// <see cref="Latest"/>.</summary>
    public bool ToolChanged { get; init; }

    /// <summary>True to begin a new lot where <see cref="Previous"/> has other key points or none, because a job was changed or the report
    /// is of an older version; false to refuse it.</summary>
    public bool MayBeginAnew { get; init; }

    /// <summary>Replaces the job's gain, more than 0 and at most 2; null keeps it.</summary>
    public double? Gain { get; init; }

    /// <summary>Values of variables that only the machine knows, in addition to the job's and instead of them.</summary>
    public AssumedValues Assumed { get; init; } = AssumedValues.None;

    /// <summary>The target folder of the program, for the report; null if the program is not written, or the folder is unknown.</summary>
    public string? Folder { get; init; }

    /// <summary>Name of the file that a program of offsets gets; null for the usual one beside the program.</summary>
    public string? OffsetsFile { get; init; }

    /// <summary>Called when the report is made; returns the calculation time in seconds. Null if it is not measured: then the
    /// same inputs give the same report.</summary>
    public Func<double>? ElapsedS { get; init; }
}
