namespace ErrorMatching.Hmi;

/// <summary>A second without decisions, because the content has just changed under a finger that was already moving.</summary>
internal sealed class Pause : IDisposable
{
    /// <summary>Its duration.</summary>
    public static readonly TimeSpan Length = TimeSpan.FromSeconds(1);

    private static readonly TimeSpan Every = TimeSpan.FromMilliseconds(100);
    private readonly TimeProvider _clock;
    private readonly Action _over;
    private readonly ITimer _timer;
    private long _since;

    /// <summary>A pause that has not begun. Call it on the UI thread.</summary>
    /// <param name="clock">The clock.</param>
    /// <param name="over">Called on the UI thread at the end of the pause.</param>
    public Pause(TimeProvider clock, Action over)
    {
        var screen = SynchronizationContext.Current ?? throw new InvalidOperationException("A pause is made on the screen's thread.");
        (_clock, _over) = (clock, over);
        _timer = clock.CreateTimer(_ => screen.Post(_ => Look(), null), null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
    }

    public bool IsOn { get; private set; }

    /// <summary>Begins or restarts it.</summary>
    public void Begin()
    {
        (_since, IsOn) = (_clock.GetTimestamp(), true);
        _timer.Change(Every, Every);
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        IsOn = false;
        _timer.Dispose();
    }

    private void Look()
    {
        if (IsOn && _clock.GetElapsedTime(_since) >= Length)
        {
            IsOn = false;
            _timer.Change(Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
            _over();
        }
    }
}
