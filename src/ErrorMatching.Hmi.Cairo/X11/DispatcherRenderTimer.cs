using System.Diagnostics;
using Avalonia.Rendering;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>Sixty frames a second on the UI thread while something is to be drawn or moves, none while nothing is.</summary>
internal sealed class DispatcherRenderTimer : IRenderTimer
{
    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private DispatcherTimer? _timer;
    private Action<TimeSpan>? _tick;

    /// <inheritdoc/>
    public bool RunsInBackground => false;

    /// <inheritdoc/>
    public Action<TimeSpan>? Tick
    {
        get => _tick;
        set
        {
            // Avalonia sets it while there is something to draw, and takes it away when there is not.
            _tick = value;
            _timer ??= new DispatcherTimer(TimeSpan.FromMilliseconds(16), DispatcherPriority.Render, (_, _) => _tick?.Invoke(_clock.Elapsed));
            _timer.IsEnabled = value is not null;
        }
    }
}
