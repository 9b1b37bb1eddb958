namespace ErrorMatching.Jobs;

/// <summary>Inputs of a free-form run in addition to the job.</summary>
public sealed record SurfaceRequest
{
    /// <summary>The measured points: one or more tables or logs of the probing program. Several files are repeated measurements
    /// of one piece.</summary>
    public required IReadOnlyList<GivenFile> Measured { get; init; }

    /// <summary>The program that cut the measured piece, instead of the one that the job names; null for the job's.</summary>
    public GivenFile? CutBy { get; init; }

    /// <summary>The report of the program that cut the measured piece, to go on from its corrections; null for a piece that a nominal
    /// program cut.</summary>
    public GivenFile? Previous { get; init; }

    /// <summary>Replaces the job's gain, 0 to 2; null keeps it.</summary>
    public double? Gain { get; init; }

    /// <summary>The target folder of the program, for the report; null if the program is not written, or the folder is unknown.</summary>
    public string? Folder { get; init; }

    /// <summary>Is told what is being done; null if nobody asks. It is called from several threads in turn.</summary>
    public IProgress<RunProgress>? Progress { get; init; }

    /// <summary>Called when the report is made; returns the calculation time in seconds. Null if it is not measured: then the
    /// same inputs give the same report.</summary>
    public Func<double>? ElapsedS { get; init; }
}
