namespace ErrorMatching.Jobs;

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
