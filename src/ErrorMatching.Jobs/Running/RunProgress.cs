namespace ErrorMatching.Jobs;

/// <summary>Progress of a run.</summary>
/// <param name="Doing">What is being done, in a few words.</param>
/// <param name="Share">The share done, 0 to 1; null if unknown.</param>
public readonly record struct RunProgress(string Doing, double? Share);

/// <summary>Progress of planning a tool path as that of a run.</summary>
public sealed class ToolPathProgress : IProgress<double>
{
    private readonly IProgress<RunProgress> _progress;

    private ToolPathProgress(IProgress<RunProgress> progress) => _progress = progress;

    /// <summary>Tells a run's progress; null if nobody asks.</summary>
    public static ToolPathProgress? Of(IProgress<RunProgress>? progress) => progress is null ? null : new(progress);

    /// <inheritdoc/>
    public void Report(double value) => _progress.Report(new("planning the tool path", value));
}
