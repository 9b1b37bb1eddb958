using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Information about the station.</summary>
internal sealed partial class AboutView : UserControl
{
    public AboutView() => InitializeComponent();
}
