using System.Runtime.CompilerServices;
using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi.Desktop;

/// <summary>Avalonia's own platform, for Windows: Win32 windows, Skia. Its assemblies are beside the station only where it was published for Windows.</summary>
internal static class WindowsPlatform
{
    /// <summary>Windows of the system, scaled as the system says, with its clipboard and input methods.</summary>
    // Not inlined: elsewhere the assembly that it calls is not there, and is asked for when this is compiled.
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static AppBuilder UseWindows(this AppBuilder builder) => builder.UsePlatformDetect().WithInterFont().With(new FontManagerOptions { DefaultFamilyName = "fonts:Inter#Inter" });
}
