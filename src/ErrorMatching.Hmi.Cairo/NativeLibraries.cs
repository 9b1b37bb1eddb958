using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>The native libraries that drawing and windows need, and the Debian packages that bring them.</summary>
public static class NativeLibraries
{
    private static readonly (string Library, string Package)[] Drawing =
    [
        (LibCairo.Library, "libcairo2"), (HarfBuzz.Library, "libharfbuzz0b"), (FreeType.Library, "libfreetype6"), (FontConfig.Library, "libfontconfig1"),
    ];

    /// <summary>What drawing off the screen needs.</summary>
    internal static IReadOnlyList<(string Library, string Package)> ForDrawing => Drawing;

    /// <summary>What a window on X11 needs.</summary>
    internal static IReadOnlyList<(string Library, string Package)> ForWindows { get; } = [.. Drawing, (Xlib.Library, "libx11-6")];

    /// <summary>The Debian packages without which nothing can be drawn on this computer; empty if all are there.</summary>
    public static IReadOnlyList<string> MissingForDrawing => Missing(ForDrawing);

    /// <summary>Makes sure that libraries can be loaded.</summary>
    /// <exception cref="PlatformNotSupportedException">One cannot; the message names the packages to install.</exception>
    internal static void Demand(IReadOnlyList<(string Library, string Package)> libraries)
    {
        if (Missing(libraries) is { Length: > 0 } missing)
        {
            throw new PlatformNotSupportedException(
                $"The operator station draws with libraries of the system, and some are missing here. Install them: apt-get install {string.Join(" ", missing)} fonts-noto-cjk");
        }
    }

    private static string[] Missing(IReadOnlyList<(string Library, string Package)> libraries) => [.. libraries.Where(l => !IsThere(l.Library)).Select(l => l.Package)];

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
