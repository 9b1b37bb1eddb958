using System.Runtime.CompilerServices;
using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi.Desktop;

/// <summary>Avalonia's own platform, for Windows: Win32 windows, Skia. Its assemblies are present only if the station was published for
/// Windows.</summary>
internal static class WindowsPlatform
{
    // Inter has no Chinese. The first is Windows' own font with the forms of Taiwan, and has a bold; without it, Windows would choose by
    // the language of the account.
    private static readonly string[] Chinese = ["Microsoft JhengHei UI", "Microsoft JhengHei", "Microsoft YaHei UI"];

    /// <summary>System windows, with the system's scaling, clipboard and input methods.</summary>
    // Not inlined: elsewhere the called assembly is missing, and compiling this method would load it.
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static AppBuilder UseWindows(this AppBuilder builder) =>
        builder.UsePlatformDetect().WithInterFont().With(new FontManagerOptions
        {
            DefaultFamilyName = "fonts:Inter#Inter",
            FontFallbacks = [.. Chinese.Select(f => new FontFallback { FontFamily = new(f) })],
        });
}
