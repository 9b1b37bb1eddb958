using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>All details of one measured surface.</summary>
public sealed partial class SurfaceDetailView : UserControl
{
    public SurfaceDetailView() => InitializeComponent();
}
