using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The station's settings.</summary>
internal sealed partial class SettingsView : UserControl
{
    public SettingsView() => InitializeComponent();
}
