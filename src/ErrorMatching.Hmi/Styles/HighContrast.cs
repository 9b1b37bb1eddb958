using Avalonia.Platform;
using Avalonia.Styling;

namespace ErrorMatching.Hmi;

/// <summary>The themes for somebody who has chosen high contrast for the whole system.</summary>
internal static class HighContrast
{
    /// <summary>Black on white.</summary>
    public static ThemeVariant Light { get; } = new(nameof(HighContrast) + nameof(Light), ThemeVariant.Light);

    /// <summary>White on black.</summary>
    public static ThemeVariant Dark { get; } = new(nameof(HighContrast) + nameof(Dark), ThemeVariant.Dark);

    /// <summary>The theme to show: with high contrast, the system's choice counts and not that of the user.</summary>
    internal static ThemeVariant Theme(bool isDark, PlatformColorValues? system) =>
        system is { ContrastPreference: ColorContrastPreference.High }
            ? system.ThemeVariant == PlatformThemeVariant.Dark ? Dark : Light
            : isDark ? ThemeVariant.Dark : ThemeVariant.Light;
}
