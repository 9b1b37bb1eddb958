namespace ErrorMatching.Hmi;

/// <summary>Asks the screen's thread ten times a second whether it has time, and tells when it took longer than a person notices: what is busy for 150 ms is always found, what is busy for 50 ms sooner or later.</summary>
/// <param name="screen">The screen's thread.</param>
/// <param name="clock">The clock that the answer is timed by.</param>
/// <param name="tell">Is given how long the answer took, beside the screen.</param>
internal sealed class ScreenWatch(SynchronizationContext screen, TimeProvider clock, Action<TimeSpan> tell)
{
    private static readonly TimeSpan Every = TimeSpan.FromMilliseconds(100), Most = TimeSpan.FromMilliseconds(50);

    /// <summary>Asks until told to end.</summary>
    public async Task RunAsync(CancellationToken end)
    {
        using var timer = new PeriodicTimer(Every, clock);
        try
        {
            while (await timer.WaitForNextTickAsync(end))
            {
                await AskAsync(end);
            }
        }
        catch (OperationCanceledException) when (end.IsCancellationRequested)
        {
            // The station ends.
        }
    }

    /// <summary>Asks once.</summary>
    internal async Task AskAsync(CancellationToken end)
    {
        var asked = clock.GetTimestamp();
        var answer = new TaskCompletionSource<TimeSpan>(TaskCreationOptions.RunContinuationsAsynchronously);
        screen.Post(_ => answer.SetResult(clock.GetElapsedTime(asked)), null);
        if (await answer.Task.WaitAsync(end) is var took && took > Most)
        {
            tell(took);
        }
    }
}
