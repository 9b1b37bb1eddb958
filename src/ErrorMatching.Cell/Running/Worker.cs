namespace ErrorMatching.Cell;

/// <summary>A loop that looks for work, does it, and waits for more. Only a request to stop ends it: after an error it reports, waits and
/// looks again.</summary>
/// <param name="flow">State shared by the workers.</param>
/// <param name="where">Its display name.</param>
/// <param name="wake">Ends its wait early.</param>
/// <param name="work">Does pending work and returns how long to wait for more; zero to look again immediately.</param>
internal sealed class Worker(CellFlow flow, string where, Wake wake, Func<CancellationToken, Task<TimeSpan>> work)
{
    /// <summary>Works until told to stop.</summary>
    public async Task RunAsync(CancellationToken stop)
    {
        var failures = 0;
        while (!stop.IsCancellationRequested)
        {
            var next = wake.Next;
            flow.Looking?.Invoke(where);
            try
            {
                var wait = await work(stop);
                failures = 0;
                if (flow.Troubles.End(where))
                {
                    flow.Log.Information("{Where}: works again", where);
                }

                if (wait > TimeSpan.Zero)
                {
                    await Task.WhenAny(next, Task.Delay(wait, flow.Clock, stop));
                }
            }
            catch (OperationCanceledException) when (stop.IsCancellationRequested)
            {
                return;
            }
            catch (StoreException e) when (e.Error == StoreError.Conflict)
            {
                // Another process took a step first: the remaining work is in the store.
                flow.Log.Debug("{Where}: {Message}", where, e.Message);
            }
            catch (SlotTakenException e)
            {
                // Another process gave the slot to another correction between the look and the step.
                flow.Log.Debug("{Where}: {Message}", where, e.Message);
            }
            catch (Exception e) when (e is not OperationCanceledException)
            {
                Report(e);
                await PauseAsync(flow.Pace.PauseAfter(e is StoreException ? 0 : failures++), stop);
            }
        }
    }

    private void Report(Exception e)
    {
        var (code, isKnown) = e switch
        {
            StoreException s => (CellCodes.Of(s.Error), true),
            SourceException => (CellCodes.GaugeAway, true),
            TransportException t => (CellCodes.Of(t.Error), true),
            BrokerException b => (CellCodes.Of(b.Error), true),
            _ => (CellCodes.Defect, false),
        };
        if (flow.Troubles.Begin(where, code, e.Message))
        {
            flow.Log.Warning(isKnown ? null : e, "{Where}: {Code}: {Message}", where, code, e.Message);
        }
    }

    private async Task PauseAsync(TimeSpan pause, CancellationToken stop)
    {
        try
        {
            await Task.Delay(pause, flow.Clock, stop);
        }
        catch (OperationCanceledException) when (stop.IsCancellationRequested)
        {
            // The loop checks for cancellation.
        }
    }
}

/// <summary>Wakes workers that wait for work. A signal between looking and waiting is not lost.</summary>
internal sealed class Wake
{
    private readonly Lock _gate = new();
    private TaskCompletionSource _next = new(TaskCreationOptions.RunContinuationsAsynchronously);

    /// <summary>The task to wait for; get it before looking for work.</summary>
    public Task Next
    {
        get
        {
            lock (_gate)
            {
                return _next.Task;
            }
        }
    }

    /// <summary>Signals that there may be work.</summary>
    public void Signal()
    {
        TaskCompletionSource done;
        lock (_gate)
        {
            done = _next;
            _next = new(TaskCreationOptions.RunContinuationsAsynchronously);
        }

        done.SetResult();
    }
}
