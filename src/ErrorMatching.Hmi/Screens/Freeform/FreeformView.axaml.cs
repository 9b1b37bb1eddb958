using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Measured surfaces and their compensation.</summary>
internal sealed partial class FreeformView : UserControl
{
    public FreeformView() => InitializeComponent();
}
