using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Where machines and gauges are tested.</summary>
public sealed partial class ConnectionsView : UserControl
{
    /// <summary>The view.</summary>
    public ConnectionsView() => InitializeComponent();
}
