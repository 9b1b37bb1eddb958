namespace ErrorMatching.Hmi.Cairo;

/// <summary>A window that is only a size, a frame and what is put in by a user that is a program. Popups are drawn inside it.</summary>
internal sealed class OffScreenWindow() : PlatformWindow(NextScaling)
{
    /// <summary>Pixels a device-independent unit of windows to come.</summary>
    public static double NextScaling { get; set; } = 1;
}
