using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Information about the station.</summary>
public sealed partial class AboutView : UserControl
{
    public AboutView() => InitializeComponent();
}
