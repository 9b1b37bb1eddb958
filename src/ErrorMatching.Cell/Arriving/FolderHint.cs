namespace ErrorMatching.Cell;

/// <summary>Says when a look into a folder may be worth it: what the system tells by itself, and the folder's time of change. Neither is believed for long.</summary>
internal sealed class FolderHint : IDisposable
{
    // File systems count time in steps of up to two seconds: a change within the step of the last look does not show.
    private static readonly TimeSpan Step = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan Longest = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(10);

    private readonly string _folder;
    private readonly TimeProvider _clock;
    private readonly SemaphoreSlim _told = new(0, 1);
    private readonly Lock _telling = new();
    private FileSystemWatcher? _watcher;
    private DateTime _changed;
    private long? _looked;
    private bool _isDisposed;

    public FolderHint(string folder, TimeProvider clock) => (_folder, _clock) = (folder, clock);

    /// <summary>True unless the folder is surely as it was at the last look.</summary>
    public bool IsWorthALook()
    {
        var changed = Directory.GetLastWriteTimeUtc(_folder);
        var same = changed == _changed && _looked is { } looked && _clock.GetElapsedTime(looked) < Longest && (_clock.GetUtcNow().UtcDateTime - changed).Duration() > Step;
        if (!same)
        {
            (_changed, _looked) = (changed, _clock.GetTimestamp());
        }

        return !same;
    }

    /// <summary>Makes the next look happen whatever the folder's time says.</summary>
    public void Forget() => _looked = null;

    /// <summary>Waits until something is told, at most for a time.</summary>
    public async Task WaitAsync(TimeSpan most, CancellationToken cancellation)
    {
        Watch();
        using var either = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        var told = _told.WaitAsync(either.Token);
        var first = await Task.WhenAny(told, Task.Delay(most, _clock, either.Token)).ConfigureAwait(false);
        await either.CancelAsync().ConfigureAwait(false);
        cancellation.ThrowIfCancellationRequested();
        if (first == told)
        {
            // Files come in bunches, and each tells several times.
            await Task.Delay(Pause, _clock, cancellation).ConfigureAwait(false);
        }
    }

    public void Dispose()
    {
        _watcher?.Dispose();
        lock (_telling)
        {
            _isDisposed = true;
            _told.Dispose();
        }
    }

    private void Watch()
    {
        if (_watcher is not null)
        {
            return;
        }

        try
        {
            _watcher = new(_folder) { NotifyFilter = NotifyFilters.FileName | NotifyFilters.LastWrite };
            _watcher.Created += (_, _) => Tell();
            _watcher.Renamed += (_, _) => Tell();
            _watcher.Changed += (_, _) => Tell();
            _watcher.EnableRaisingEvents = true;
        }
        catch (Exception e) when (e is IOException or ArgumentException or UnauthorizedAccessException)
        {
            // A share that tells nothing, a folder that is away, no more watches: looking from time to time does it alone, and the next wait tries again.
            _watcher?.Dispose();
            _watcher = null;
        }
    }

    private void Tell()
    {
        lock (_telling)
        {
            if (!_isDisposed && _told.CurrentCount == 0)
            {
                _told.Release();
            }
        }
    }
}
