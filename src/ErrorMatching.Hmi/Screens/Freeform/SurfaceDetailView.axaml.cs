using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>All details of one measured surface.</summary>
internal sealed partial class SurfaceDetailView : UserControl
{
    public SurfaceDetailView() => InitializeComponent();
}
