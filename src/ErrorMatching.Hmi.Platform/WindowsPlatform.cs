using Avalonia;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Avalonia on Windows: the same drawing, windows of Win32 by P/Invoke.</summary>
public static class WindowsPlatform
{
    // Per monitor, version 2: the system draws nothing larger by itself, and tells when a window comes to another monitor.
    private const nint PerMonitor = -4;

    /// <summary>Windows of this session.</summary>
    /// <param name="builder">The application.</param>
    /// <param name="scaling">Size of everything, 1 to 4, in addition to the system's own scaling.</param>
    /// <exception cref="PlatformNotSupportedException">The session has no screen.</exception>
    /// <exception cref="FileNotFoundException">The station's fonts are not where they belong.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The scaling is not from 1 to 4.</exception>
    public static AppBuilder UseWin32(this AppBuilder builder, double scaling = 1)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(scaling, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(scaling, 4);
        return builder.UseSkia().UseWindowingSubsystem(
            () =>
            {
                _ = User32.SetProcessDpiAwarenessContext(PerMonitor);
                var settings = new Win32Settings();
                Windowing.Initialize(
                    new DispatcherRenderTimer(),
                    () => new Win32Window(scaling, settings),
                    new Win32Clipboard(),
                    new Win32Dispatcher(),
                    settings);
            },
            "Win32");
    }
}
