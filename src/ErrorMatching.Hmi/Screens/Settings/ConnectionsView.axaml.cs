using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Test of machines and gauges.</summary>
internal sealed partial class ConnectionsView : UserControl
{
    public ConnectionsView() => InitializeComponent();
}
