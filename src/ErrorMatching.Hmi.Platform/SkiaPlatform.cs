using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>What is the same on every system: drawing with Skia, text with HarfBuzz.</summary>
internal static class SkiaPlatform
{
    /// <summary>The font of texts. Characters that it lacks, such as Chinese, come from the station's other fonts, then from the
    /// system's.</summary>
    public const string FontFamily = "fonts:Inter#Inter";

    /// <summary>Draws with Skia; windows come from another subsystem.</summary>
    public static AppBuilder UseSkia(this AppBuilder builder)
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
