using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>How large the monitor is, so that 15 mm of a touch target are 15 mm of the screen.</summary>
internal static unsafe partial class X11Monitor
{
    private const string Library = "libXrandr.so.2";
    private const double UnitsPerMm = 96 / 25.4;

    // Steps small enough for fingers, and large enough that rounding of a monitor's size makes no odd ones.
    private const double Step = 0.05;
    private const double Most = 2;

    // What everything fits into without being cut off.
    private const int LeastWidth = 1280, LeastHeight = 800;

    // Some monitors state their shape instead of their size.
    private static readonly (int, int)[] Shapes = [(16, 9), (16, 10), (160, 90), (160, 100), (1600, 900), (1600, 1000)];

    /// <summary>Pixels per device-independent unit on the primary monitor, or on the first one: from 1 to 2, in steps of 5 %; 1 if its size
    /// is not known.</summary>
    /// <exception cref="PlatformNotSupportedException">There is no X server.</exception>
    public static double Scaling()
    {
        X11Connection.Open();
        if (!NativeLibraries.IsThere(Library))
        {
            return 1;
        }

        var root = Xlib.XRootWindow(X11Connection.Display, Xlib.XDefaultScreen(X11Connection.Display));
        int count;
        var monitors = XRRGetMonitors(X11Connection.Display, root, 1, &count);
        if (monitors is null)
        {
            return 1;
        }

        var chosen = 0;
        for (var i = count - 1; i >= 0; i--)
        {
            chosen = monitors[i].IsPrimary != 0 ? i : chosen;
        }

        var scaling = count < 1 ? 1
            : ScalingOf(monitors[chosen].Width, monitors[chosen].Height, monitors[chosen].WidthMm, monitors[chosen].HeightMm);
        XRRFreeMonitors(monitors);
        X11Connection.DrainLater();
        return scaling;
    }

    /// <summary>Pixels per device-independent unit of a monitor: as many as a 96th of an inch has there, but not so many that something is
    /// cut off.</summary>
    /// <param name="width">Its width in pixels.</param>
    /// <param name="height">Its height in pixels.</param>
    /// <param name="widthMm">Its width in mm as it states it; 0 if it does not.</param>
    /// <param name="heightMm">Its height in mm as it states it; 0 if it does not.</param>
    internal static double ScalingOf(int width, int height, int widthMm, int heightMm)
    {
        if (widthMm <= 0 || heightMm <= 0 || Shapes.Contains((widthMm, heightMm)))
        {
            return 1;
        }

        var bySize = width / (widthMm * UnitsPerMm);
        var byRoom = Math.Min((double)width / LeastWidth, (double)height / LeastHeight);

        // Less than a hundredth of a step is rounding.
        var steps = Math.Floor((Math.Min(bySize, byRoom) / Step) + 0.01);
        return Math.Clamp(steps * Step, 1, Most);
    }

    [LibraryImport(Library)] private static partial Monitor* XRRGetMonitors(nint display, nint window, int isActive, int* count);

    [LibraryImport(Library)] private static partial void XRRFreeMonitors(Monitor* monitors);

    // XRRMonitorInfo of XRandR 1.5.
    [StructLayout(LayoutKind.Sequential)]
    private struct Monitor
    {
        public nint Name;
        public int IsPrimary, IsAutomatic, OutputCount, X, Y, Width, Height, WidthMm, HeightMm;
        public nint Outputs;
    }
}
