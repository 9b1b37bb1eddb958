using System.Diagnostics;
using Avalonia.Rendering;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Sixty frames per second on the UI thread while there is something to draw or animate, none otherwise.</summary>
internal sealed class DispatcherRenderTimer : IRenderTimer
{
    private readonly Stopwatch _clock = Stopwatch.StartNew();
    private DispatcherTimer? _timer;
    private Action<TimeSpan>? _tick;

    public bool RunsInBackground => false;

    public Action<TimeSpan>? Tick
    {
        get => _tick;
        set
        {
            // Avalonia sets it while there is something to draw, and clears it otherwise.
            _tick = value;
            _timer ??= new DispatcherTimer(
                TimeSpan.FromMilliseconds(16), DispatcherPriority.Render, (_, _) => _tick?.Invoke(_clock.Elapsed));
            _timer.IsEnabled = value is not null;
        }
    }
}
