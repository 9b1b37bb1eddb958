using Avalonia.Rendering;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>The clock of frames that nobody sees: one is drawn when somebody says so.</summary>
internal sealed class OffScreenClock : IRenderTimer
{
    private TimeSpan _now;

    /// <summary>The one of the process.</summary>
    public static OffScreenClock Current { get; } = new();

    /// <inheritdoc/>
    public Action<TimeSpan>? Tick { get; set; }

    /// <inheritdoc/>
    public bool RunsInBackground => false;

    /// <summary>Does the pending work of the UI thread, then draws one frame, so many times.</summary>
    public void Advance(int frames = 2)
    {
        for (var i = 0; i < frames; i++)
        {
            Dispatcher.UIThread.RunJobs(null);
            Frame();
        }

        Dispatcher.UIThread.RunJobs(null);
    }

    /// <summary>Draws one frame, a sixtieth of a second later than the last one.</summary>
    public void Frame() => Tick?.Invoke(_now += TimeSpan.FromMilliseconds(16));
}
