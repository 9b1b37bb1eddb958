namespace ErrorMatching.Hmi;

/// <summary>Posts to the UI thread ten times a second and reports responses slower than a person notices. A block of 150 ms is
/// always found, one of 50 ms sooner or later.</summary>
/// <param name="screen">The UI thread.</param>
/// <param name="clock">The clock that times the response.</param>
/// <param name="tell">Receives the response time, off the UI thread.</param>
internal sealed class ScreenWatch(SynchronizationContext screen, TimeProvider clock, Action<TimeSpan> tell)
{
    private static readonly TimeSpan Every = TimeSpan.FromMilliseconds(100), Most = TimeSpan.FromMilliseconds(50);

    /// <summary>Runs until canceled.</summary>
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
            // The station is closing.
        }
    }

    /// <summary>Measures one response.</summary>
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
