using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The color of a window's title bar.</summary>
internal static unsafe partial class Dwmapi
{
    /// <summary>For <see cref="DwmSetWindowAttribute"/>: a dark title bar (Windows 11, and Windows 10 from 2004 on).</summary>
    public const uint DarkTitle = 20;

    // Other than the others, it is searched beside the program first.
    [LibraryImport("dwmapi")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.System32)]
    public static partial int DwmSetWindowAttribute(nint window, uint attribute, void* value, uint bytes);
}
