using System.Diagnostics;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The message loop of the UI thread. It waits for messages, for the next timer and for work of other threads.</summary>
/// <remarks>Moving a window and opening its menu run the system's own loop, which knows nothing of this one's timer. Meanwhile, one of the
/// system's timers replaces it, which is less exact.</remarks>
internal sealed unsafe class Win32Dispatcher : IControlledDispatcherImpl
{
    private const nint TimerId = 1;
    private const uint Removes = 1, Forever = uint.MaxValue;

    // Keys, mouse, touch and pen; and for the loop, everything. Also what has been looked at, but not taken.
    private const uint Input = 0x1C07, Anything = 0x1CFF, AlsoSeen = 4;
    private static Win32Dispatcher? _current;
    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private readonly Thread _thread = Thread.CurrentThread;
    private readonly nint _timer;
    private long? _due;
    private bool _isSystemsLoop;

    /// <summary>Makes the current thread the UI thread.</summary>
    public Win32Dispatcher()
    {
        _current = this;
        Win32Class.Register();
        Messages = Win32Class.Create(0, User32.MessagesOnly, On);
        _timer = Kernel32.CreateWaitableTimer(0, 0, Kernel32.Exact, Kernel32.AllAccess);
        if (_timer == 0)
        {
            _timer = Kernel32.CreateWaitableTimer(0, 0, 0, Kernel32.AllAccess);
        }
    }

    public event Action? Signaled;

    public event Action? Timer;

    /// <summary>A window that only receives messages. It also owns what is copied.</summary>
    public static nint OwnerOfMessages => _current?.Messages ?? 0;

    public bool CurrentThreadIsLoopThread => Thread.CurrentThread == _thread;

    public bool CanQueryPendingInput => true;

    public bool HasPendingInput => User32.MsgWaitForMultipleObjectsEx(0, null, 0, Input, AlsoSeen) == 0;

    public long Now => _clock.ElapsedMilliseconds;

    private nint Messages { get; }

    /// <summary>Call when the system begins or ends a loop of its own.</summary>
    public static void OnSystemsLoop(bool isRunning)
    {
        if (_current is { } current)
        {
            current._isSystemsLoop = isRunning;
            current.Arm();
        }
    }

    public void Signal() => _ = User32.PostMessage(Messages, Win32Message.Work, 0, 0);

    public void UpdateTimer(long? dueTimeInMs)
    {
        _due = dueTimeInMs;
        Arm();
    }

    public void RunLoop(CancellationToken token)
    {
        using var wake = token.Register(Signal);
        var timer = _timer;
        User32.Message message;
        while (!token.IsCancellationRequested)
        {
            if (_due <= Now)
            {
                Elapse();
            }
            else if (User32.PeekMessage(&message, 0, 0, 0, Removes) == 0)
            {
                var isTimer = User32.MsgWaitForMultipleObjectsEx(timer == 0 ? 0u : 1, &timer, Forever, Anything, AlsoSeen) == 0;
                if (isTimer && timer != 0 && _due > Now)
                {
                    // The two clocks differ a little: it waits for the rest.
                    Arm();
                }
            }
            else if (message.Window == Messages && message.Kind == Win32Message.Work)
            {
                // Not through the system, so that an exception that nobody handles ends the program.
                Signaled?.Invoke();
            }
            else
            {
                _ = User32.TranslateMessage(&message);
                _ = User32.DispatchMessage(&message);
            }

            // The timer comes between two messages, so that neither waits for the other for long.
        }
    }

    private void Elapse()
    {
        _due = null;
        Timer?.Invoke();
    }

    private void Arm()
    {
        if (_due is { } due && (_isSystemsLoop || _timer == 0))
        {
            _ = User32.SetTimer(Messages, TimerId, (uint)Math.Clamp(due - Now, 1, int.MaxValue), 0);
        }
        else
        {
            _ = User32.KillTimer(Messages, TimerId);
        }

        if (_due is { } at && _timer != 0)
        {
            // Negative: from now, in 100 ns.
            var wait = -Math.Max(1, (at - Now) * 10_000);
            _ = Kernel32.SetWaitableTimer(_timer, &wait, 0, 0, 0, 0);
        }
    }

    private nint? On(uint message, nint w, nint l)
    {
        switch (message)
        {
            case Win32Message.Work:
                Signaled?.Invoke();
                return 0;
            case Win32Message.Timer:
                _ = User32.KillTimer(Messages, TimerId);
                if (_due <= Now)
                {
                    Elapse();
                }
                else
                {
                    Arm();
                }

                return 0;
            default:
                return null;
        }
    }
}
