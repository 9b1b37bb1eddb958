using Avalonia;

namespace ErrorMatching.Hmi.Desktop;

/// <summary>What opens windows and draws on this system.</summary>
internal static partial class StationPlatform
{
    /// <summary>Adds it.</summary>
    /// <param name="builder">The application.</param>
    /// <param name="scaling">Size of everything; Windows has a setting of its own.</param>
    /// <param name="tell">Receives what is missing, such as a library for fingers.</param>
    public static AppBuilder Use(AppBuilder builder, double scaling, Action<string> tell)
    {
        if (OperatingSystem.IsWindows())
        {
            return builder.UseWindows();
        }

        UseX11(ref builder, scaling, tell);
        return builder;
    }

    // Compiled for other systems than Windows, where what it calls is not shipped.
    static partial void UseX11(ref AppBuilder builder, double scaling, Action<string> tell);
}
