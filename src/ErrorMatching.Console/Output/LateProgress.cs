using System.Runtime.CompilerServices;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary>Progress of an operation that usually takes less than a second: shown like that of long ones, once a second has
/// passed.</summary>
internal sealed class LateProgress : IProgress<RunProgress>, IDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(1);

    private readonly ProgressLine _line;
    private readonly ITimer? _timer;
    private readonly Lock _lock = new();
    private RunProgress? _last;
    private bool _isShown;

    /// <summary>Begins to wait.</summary>
    /// <param name="terminal">The terminal; null if no person is watching.</param>
    public LateProgress(TextWriter? terminal)
    {
        _line = new(terminal);
        _timer = terminal is null ? null : OfSystem();
    }

    /// <summary>The same by another clock.</summary>
    public LateProgress(TextWriter? terminal, TimeProvider clock)
    {
        _line = new(terminal);
        _timer = terminal is null ? null : Begin(clock);
    }

    /// <summary>Notes that an operation without a known share begins.</summary>
    public void Report(string doing) => Report(new RunProgress(doing, null));

    public void Report(RunProgress value)
    {
        lock (_lock)
        {
            _last = value;
            if (_isShown)
            {
                Write(value);
            }
        }
    }

    public void Dispose()
    {
        _timer?.Dispose();
        lock (_lock)
        {
            // A call of the timer that waits here shows nothing any more.
            (_last, _isShown) = (null, false);
            _line.Dispose();
        }
    }

    // In a method of its own: a clock is loaded only where somebody watches.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private ITimer OfSystem() => Begin(TimeProvider.System);

    private ITimer Begin(TimeProvider clock) => clock.CreateTimer(_ => Show(), null, Patience, Timeout.InfiniteTimeSpan);

    private void Show()
    {
        lock (_lock)
        {
            if (_last is { } last)
            {
                _isShown = true;
                Write(last);
            }
        }
    }

    private void Write(RunProgress value) =>
        _line.Show(value.Doing, (long)(100 * (value.Share ?? 0)), value.Share is null ? 0 : 100);
}
