using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Measured surfaces, and what is made of them.</summary>
public sealed partial class FreeformView : UserControl
{
    /// <summary>The view.</summary>
    public FreeformView() => InitializeComponent();
}
