using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Testing;

/// <summary>A window that has only a size, a frame and input from a simulated user. Popups are drawn inside it.</summary>
internal sealed class OffScreenWindow() : PlatformWindow(NextScaling)
{
    /// <summary>Pixels per device-independent unit, for future windows.</summary>
    public static double NextScaling { get; set; } = 1;
}
