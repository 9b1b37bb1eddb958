namespace ErrorMatching.Cell;

/// <summary>Decides when a look into a folder may be worthwhile, from the system's change notifications and the folder's modification time.
/// Neither is trusted for long.</summary>
internal sealed class FolderHint : IDisposable
{
    // File systems record time in steps of up to two seconds: a change within the same step as the last look does not show.
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

    /// <summary>False only if the folder certainly has not changed since the last look.</summary>
    public bool IsWorthALook()
    {
        var changed = Directory.GetLastWriteTimeUtc(_folder);
        var same = changed == _changed
            && _looked is { } looked
            && _clock.GetElapsedTime(looked) < Longest
            && (_clock.GetUtcNow().UtcDateTime - changed).Duration() > Step;
        if (!same)
        {
            (_changed, _looked) = (changed, _clock.GetTimestamp());
        }

        return !same;
    }

    /// <summary>Forces the next look, regardless of the folder's modification time.</summary>
    public void Forget() => _looked = null;

    /// <summary>Waits for a change notification, up to a time limit.</summary>
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
            // Files arrive in bursts, and each causes several notifications.
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
            _watcher.Created += (_, _) => Report();
            _watcher.Renamed += (_, _) => Report();
            _watcher.Changed += (_, _) => Report();
            _watcher.EnableRaisingEvents = true;
        }
        catch (Exception e) when (e is IOException or ArgumentException or UnauthorizedAccessException)
        {
            // The share sends no notifications, the folder is gone, or there are no watches left. Polling alone is enough, and the next
            // wait tries again.
            _watcher?.Dispose();
            _watcher = null;
        }
    }

    private void Report()
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
