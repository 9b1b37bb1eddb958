using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The station's settings.</summary>
public sealed partial class SettingsView : UserControl
{
    public SettingsView() => InitializeComponent();
}
