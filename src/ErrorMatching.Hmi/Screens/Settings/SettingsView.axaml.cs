using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Where the station is set up.</summary>
public sealed partial class SettingsView : UserControl
{
    /// <summary>The view.</summary>
    public SettingsView() => InitializeComponent();
}
