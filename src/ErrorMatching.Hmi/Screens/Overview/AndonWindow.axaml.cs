using Avalonia;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The overview for a wall: nobody signs in, and nothing can be done there.</summary>
public sealed partial class AndonWindow : Window
{
    public AndonWindow() => InitializeComponent();

    /// <summary>True for the dark theme.</summary>
    internal bool IsDark
    {
        init => RequestedThemeVariant = HighContrast.Theme(value, Application.Current!.PlatformSettings?.GetColorValues());
    }
}
