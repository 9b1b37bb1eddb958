using Avalonia.Rendering;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Testing;

/// <summary>The clock of off-screen frames: a frame is drawn on request.</summary>
internal sealed class OffScreenClock : IRenderTimer
{
    private TimeSpan _now;

    /// <summary>The process's clock.</summary>
    public static OffScreenClock Current { get; } = new();

    public Action<TimeSpan>? Tick { get; set; }

    public bool RunsInBackground => false;

    /// <summary>Does the UI thread's pending work, then draws one frame; repeats this for the given number of frames.</summary>
    public void Advance(int frames = 2)
    {
        for (var i = 0; i < frames; i++)
        {
            Dispatcher.UIThread.RunJobs(null);
            Frame();
        }

        Dispatcher.UIThread.RunJobs(null);
    }

    /// <summary>Draws one frame, 16 ms after the previous one.</summary>
    public void Frame() => Tick?.Invoke(_now += TimeSpan.FromMilliseconds(16));
}
