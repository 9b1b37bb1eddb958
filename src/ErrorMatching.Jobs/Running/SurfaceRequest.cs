namespace ErrorMatching.Jobs;

/// <summary>What a free-form job is run with, beside what it names itself.</summary>
public sealed record SurfaceRequest
{
    /// <summary>The measured points, one file at least: tables, or logs of the probing program. Several are repeated measurements of one piece.</summary>
    public required IReadOnlyList<GivenFile> Measured { get; init; }

    /// <summary>The program that cut the measured piece, in the place of the one that the job names; null leaves that.</summary>
    public GivenFile? CutBy { get; init; }

    /// <summary>Takes the place of the job's gain, 0 to 2; null leaves it.</summary>
    public double? Gain { get; init; }

    /// <summary>The folder that the program will stand in, for the report; null if it is not written, or nobody knows where.</summary>
    public string? Folder { get; init; }

    /// <summary>Asked when the report is made: how long the calculation took, in seconds. Null where nobody times it: then the same inputs give the same report.</summary>
    public Func<double>? ElapsedS { get; init; }
}
