using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>One measured surface with all that is known of it.</summary>
public sealed partial class SurfaceDetailView : UserControl
{
    /// <summary>The view.</summary>
    public SurfaceDetailView() => InitializeComponent();
}
