using Avalonia;
using Avalonia.Animation;
using Avalonia.Controls;
using Avalonia.Platform;
using Avalonia.Styling;

namespace ErrorMatching.Hmi.Platform;

/// <summary>What a person chose for the whole of Windows: high contrast, and no motion.</summary>
internal sealed unsafe class Win32Settings : DefaultPlatformSettings
{
    // Indices of GetSysColor: the ground of windows, and text on it.
    private const int Ground = 5, Ink = 8;

    private bool _isStill;

    /// <summary>No control changes its looks gradually.</summary>
    public static Style Still { get; } = new(s => s.Is<Control>()) { Setters = { new Setter(Animatable.TransitionsProperty, null) } };

    public override PlatformColorValues GetColorValues() => new()
    {
        ThemeVariant = Brightness(User32.GetSysColor(Ground)) < Brightness(User32.GetSysColor(Ink))
            ? PlatformThemeVariant.Dark
            : PlatformThemeVariant.Light,
        ContrastPreference = IsHighContrast ? ColorContrastPreference.High : ColorContrastPreference.NoPreference,
    };

    private static bool IsHighContrast
    {
        get
        {
            var contrast = new User32.HighContrast { Bytes = (uint)sizeof(User32.HighContrast) };
            return User32.GetParameter(User32.GetHighContrast, contrast.Bytes, &contrast, 0) != 0 && (contrast.Flags & 1) != 0;
        }
    }

    private static bool IsStill
    {
        get
        {
            var isAnimated = 1;
            return User32.GetParameter(User32.GetAnimation, 0, &isAnimated, 0) != 0 && isAnimated == 0;
        }
    }

    /// <summary>Follows the system: once at the start, and when it says that a setting has changed.</summary>
    public void Follow()
    {
        OnColorValuesChanged(GetColorValues());
        if (_isStill != IsStill && Application.Current is { } application)
        {
            _isStill = !_isStill;
            if (_isStill)
            {
                application.Styles.Add(Still);
            }
            else
            {
                _ = application.Styles.Remove(Still);
            }
        }
    }

    // Red, green and blue are the lowest three bytes.
    private static uint Brightness(uint color) => (color & 0xFF) + (color >> 8 & 0xFF) + (color >> 16 & 0xFF);
}
