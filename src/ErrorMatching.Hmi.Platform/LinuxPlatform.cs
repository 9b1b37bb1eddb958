using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Avalonia on Linux: drawing with Skia, text with HarfBuzz, windows on X11 by P/Invoke.</summary>
public static class LinuxPlatform
{
    /// <summary>The font of texts. Characters that it lacks, such as Chinese, come from the station's other fonts, then from the
    /// system's.</summary>
    public const string FontFamily = "fonts:Inter#Inter";

    /// <summary>Windows on the X server that <c>DISPLAY</c> names, with the same drawing.</summary>
    /// <param name="builder">The application.</param>
    /// <param name="scaling">Pixels per device-independent unit, 1 to 4.</param>
    /// <param name="advise">Told what to install if something is missing without which the station starts nevertheless.</param>
    /// <exception cref="PlatformNotSupportedException">A native library is missing; the message names the packages to install.</exception>
    /// <exception cref="FileNotFoundException">The station's fonts are not where they belong.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The scaling is not from 1 to 4.</exception>
    public static AppBuilder UseX11(this AppBuilder builder, double scaling = 1, Action<string>? advise = null)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(scaling, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(scaling, 4);
        NativeLibraries.Demand(NativeLibraries.ForWindows);
        return builder.UseSkia()
            .UseWindowingSubsystem(
                () => Windowing.Initialize(new DispatcherRenderTimer(), () => new X11Window(scaling, advise), new X11Clipboard()), "X11");
    }

    /// <summary>Draws with Skia; windows come from another subsystem.</summary>
    internal static AppBuilder UseSkia(this AppBuilder builder)
    {
        ArgumentNullException.ThrowIfNull(builder);
        var fonts = new StationFonts(FontFolders.Own, FontFolders.Usual);
        return builder
            .UseStandardRuntimePlatformSubsystem()
            .With(new FontManagerOptions { DefaultFamilyName = FontFamily, FontFallbacks = fonts.HanFallbacks })
            .WithInterFont()
            .UseTextShapingSubsystem(
                () => AvaloniaLocator.CurrentMutable.Bind<ITextShaperImpl>().ToConstant(new HarfBuzzShaper()), "HarfBuzz")
            .UseRenderingSubsystem(
                () => AvaloniaLocator.CurrentMutable
                    .Bind<IPlatformRenderInterface>().ToConstant(new SkiaRenderInterface())
                    .Bind<IFontManagerImpl>().ToConstant(fonts),
                "Skia");
    }
}
