using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The native libraries that the system must have, and the Debian packages that contain them.</summary>
internal static class NativeLibraries
{
    /// <summary>The libraries for a window on X11. What draws comes with the station.</summary>
    public static IReadOnlyList<(string Library, string Package)> ForWindows { get; } = [(Xlib.Library, "libx11-6")];

    /// <summary>Ensures that libraries can be loaded.</summary>
    /// <exception cref="PlatformNotSupportedException">One cannot; the message names the packages to install.</exception>
    public static void Demand(IReadOnlyList<(string Library, string Package)> libraries)
    {
        if (libraries.Where(l => !IsThere(l.Library)).Select(l => l.Package).ToArray() is { Length: > 0 } missing)
        {
            throw new PlatformNotSupportedException(
                $"The operator station needs libraries of the system, and some are missing here. Install them: apt-get install "
                    + $"{string.Join(" ", missing)}");
        }
    }

    /// <summary>True if a library can be loaded.</summary>
    public static bool IsThere(string library)
    {
        if (!NativeLibrary.TryLoad(library, out var handle))
        {
            return false;
        }

        NativeLibrary.Free(handle);
        return true;
    }
}
