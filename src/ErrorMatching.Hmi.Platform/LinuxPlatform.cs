using Avalonia;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Avalonia on Linux: drawing with Skia, text with HarfBuzz, windows on X11 by P/Invoke.</summary>
public static class LinuxPlatform
{
    /// <summary>Windows on the X server that <c>DISPLAY</c> names, with the same drawing.</summary>
    /// <param name="builder">The application.</param>
    /// <param name="scaling">Pixels per device-independent unit, 1 to 4; null for what the monitor's size asks for.</param>
    /// <param name="advise">Told what to install if something is missing without which the station starts nevertheless.</param>
    /// <exception cref="PlatformNotSupportedException">A native library is missing; the message names the packages to install.</exception>
    /// <exception cref="FileNotFoundException">The station's fonts are not where they belong.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The scaling is not from 1 to 4.</exception>
    public static AppBuilder UseX11(this AppBuilder builder, double? scaling = 1, Action<string>? advise = null)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(scaling ?? 1, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(scaling ?? 1, 4);
        NativeLibraries.Demand(NativeLibraries.ForWindows);
        return builder.UseSkia()
            .UseWindowingSubsystem(
                () => Windowing.Initialize(
                    new DispatcherRenderTimer(), () => new X11Window(scaling ?? X11Monitor.Scaling(), advise), new X11Clipboard()),
                "X11");
    }
}
