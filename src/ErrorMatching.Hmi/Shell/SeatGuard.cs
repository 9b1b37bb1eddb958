using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Keeps the session of the user at the station alive while there is input, and notices once a second that it has ended. The
/// store is used in the background: the end of a session is written to it.</summary>
internal sealed class SeatGuard : IDisposable
{
    private static readonly TimeSpan Look = TimeSpan.FromSeconds(1);
    private readonly Station _station;
    private readonly Action _left;
    private readonly SynchronizationContext _screen;
    private readonly ITimer _timer;
    private long _touched;
    private int _arrivals;
    private bool _isOver;

    /// <summary>Starts to look. Call it on the UI thread.</summary>
    /// <param name="station">The station.</param>
    /// <param name="left">Called on the UI thread while no session is open.</param>
    public SeatGuard(Station station, Action left)
    {
        (_station, _left) = (station, left);
        _screen = SynchronizationContext.Current ?? throw new InvalidOperationException("A seat is guarded on the screen's thread.");
        _timer = station.Clock.CreateTimer(_ => LookForUser(), null, Look, Look);
    }

    /// <summary>Call this on every key press or tap. It does work once a second at most.</summary>
    public void Touch()
    {
        if (_station.Clock.GetElapsedTime(_touched) >= Look)
        {
            _touched = _station.Clock.GetTimestamp();
            _ = Task.Run(KeepAlive).Watched();
        }
    }

    /// <summary>Call this on the UI thread when somebody has signed in: what was seen before is about an empty seat.</summary>
    public void Arrive() => _arrivals++;

    /// <summary>Ends the session.</summary>
    public Task LeaveAsync() => Task.Run(Leave, CancellationToken.None);

    /// <inheritdoc/>
    public void Dispose()
    {
        _isOver = true;
        _timer.Dispose();
    }

    private void KeepAlive()
    {
        try
        {
            _station.Session.Touch();
        }
        catch (StoreException)
        {
            // The session had just ended, and that could not be recorded: the banner shows that the store is unavailable.
        }
    }

    private void Leave()
    {
        try
        {
            _station.Session.SignOut();
        }
        catch (StoreException)
        {
            // The session has ended anyway.
        }
    }

    private void LookForUser()
    {
        var arrivals = Volatile.Read(ref _arrivals);
        try
        {
            if (_station.Session.Who is not null)
            {
                return;
            }
        }
        catch (StoreException)
        {
            // The session counts as ended although that could not be recorded: the banner shows that the store is unavailable.
        }

        _screen.Post(
            _ =>
            {
                if (!_isOver && arrivals == _arrivals)
                {
                    _left();
                }
            },
            null);
    }
}
