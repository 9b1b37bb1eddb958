namespace ErrorMatching.Freeform;

/// <summary>Adds up the shares of a path that several cores have planned, and reports the sum.</summary>
/// <param name="progress">Gets the share, 0 to 1; null if nobody asks.</param>
internal sealed class PlanningProgress(IProgress<double>? progress)
{
    private readonly Lock _lock = new();
    private double _planned;

    /// <summary>Adds a share.</summary>
    public void Add(double share)
    {
        if (progress is null)
        {
            return;
        }

        lock (_lock)
        {
            _planned = Math.Min(1, _planned + share);
            progress.Report(_planned);
        }
    }
}
