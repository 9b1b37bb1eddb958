using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The native libraries for drawing and windows, and the Debian packages that contain them.</summary>
public static class NativeLibraries
{
    private static readonly (string Library, string Package)[] Drawing =
    [
        (LibCairo.Library, "libcairo2"), (HarfBuzz.Library, "libharfbuzz0b"), (FreeType.Library, "libfreetype6"),
        (FontConfig.Library, "libfontconfig1"),
    ];

    /// <summary>The libraries for drawing off screen.</summary>
    internal static IReadOnlyList<(string Library, string Package)> ForDrawing => Drawing;

    /// <summary>The libraries for a window on X11.</summary>
    internal static IReadOnlyList<(string Library, string Package)> ForWindows { get; } = [.. Drawing, (Xlib.Library, "libx11-6")];

    /// <summary>The missing Debian packages without which nothing can be drawn on this computer; empty if none is missing.</summary>
    public static IReadOnlyList<string> MissingForDrawing => Missing(ForDrawing);

    /// <summary>Ensures that libraries can be loaded.</summary>
    /// <exception cref="PlatformNotSupportedException">One cannot; the message names the packages to install.</exception>
    internal static void Demand(IReadOnlyList<(string Library, string Package)> libraries)
    {
        if (Missing(libraries) is { Length: > 0 } missing)
        {
            throw new PlatformNotSupportedException(
                $"The operator station draws with libraries of the system, and some are missing here. Install them: apt-get install "
                    + $"{string.Join(" ", missing)} fonts-noto-cjk");
        }
    }

    private static string[] Missing(IReadOnlyList<(string Library, string Package)> libraries) =>
        [.. libraries.Where(l => !IsThere(l.Library)).Select(l => l.Package)];

    private static bool IsThere(string library)
    {
        if (!NativeLibrary.TryLoad(library, out var handle))
        {
            return false;
        }

        NativeLibrary.Free(handle);
        return true;
    }
}
