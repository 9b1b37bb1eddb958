using Avalonia;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Testing;

/// <summary>Windows without a screen, with the same drawing as on X11.</summary>
public static class OffScreenPlatform
{
    /// <summary>Windows without a screen; <see cref="ScreenUser"/> requests each frame.</summary>
    /// <exception cref="PlatformNotSupportedException">A native library is missing; the message names the packages to install.</exception>
    public static AppBuilder UseOffScreen(this AppBuilder builder) => builder.UseSkia()
        .UseWindowingSubsystem(
            () => Windowing.Initialize(
                OffScreenClock.Current,
                () => new OffScreenWindow(),
                new MemoryClipboard(),
                settings: OffScreenSettings.Current),
            "off-screen");
}
