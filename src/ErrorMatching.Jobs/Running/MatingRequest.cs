namespace ErrorMatching.Jobs;

/// <summary>What a mating job is run with, beside what it names itself.</summary>
public sealed record MatingRequest
{
    /// <summary>The key points as designed; null for the job's.</summary>
    public GivenFile? Theoretical { get; init; }

    /// <summary>The measured part; null for the job's.</summary>
    public GivenFile? Part { get; init; }

    /// <summary>The measured counterpart; null for the job's, which only feedback needs.</summary>
    public GivenFile? Counterpart { get; init; }

    /// <summary>The counterpart's program; null for the job's.</summary>
    public GivenFile? Program { get; init; }

    /// <summary>Takes the place of the job's gain, more than 0 and at most 2; null leaves it.</summary>
    public double? Gain { get; init; }

    /// <summary>The folder that the program will stand in, for the report; null if it is not written, or nobody knows where.</summary>
    public string? Folder { get; init; }

    /// <summary>Asked when the report is made: how long the calculation took, in seconds. Null where nobody times it: then the same inputs give the same report.</summary>
    public Func<double>? ElapsedS { get; init; }
}
