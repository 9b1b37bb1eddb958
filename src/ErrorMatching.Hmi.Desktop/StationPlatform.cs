using Avalonia;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Desktop;

/// <summary>What opens windows and draws on this system.</summary>
internal static class StationPlatform
{
    /// <summary>Adds it.</summary>
    /// <param name="builder">The application.</param>
    /// <param name="scaling">Size of everything; on Windows in addition to the system's own. Null for the usual one.</param>
    /// <param name="tell">Receives what is missing, such as a library for fingers.</param>
    public static AppBuilder Use(AppBuilder builder, double? scaling, Action<string> tell) =>
        OperatingSystem.IsWindows() ? builder.UseWin32(scaling ?? 1) : builder.UseX11(scaling, tell);
}
