using Avalonia.Platform;

namespace ErrorMatching.Hmi.Testing;

/// <summary>What a person chose for the whole system; nothing in particular until a test says so.</summary>
public sealed class OffScreenSettings : DefaultPlatformSettings
{
    private PlatformColorValues _colors = new();

    /// <summary>The process's settings.</summary>
    public static OffScreenSettings Current { get; } = new();

    /// <inheritdoc/>
    public override PlatformColorValues GetColorValues() => _colors;

    /// <summary>A person chooses other colors.</summary>
    /// <param name="contrast">High, or no preference.</param>
    /// <param name="variant">Text is lighter than its ground, or darker.</param>
    public void Choose(ColorContrastPreference contrast, PlatformThemeVariant variant)
    {
        _colors = new() { ContrastPreference = contrast, ThemeVariant = variant };
        OnColorValuesChanged(_colors);
    }
}
