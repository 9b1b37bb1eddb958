using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A theoretical point: its feature, and the fields for label and coordinates.</summary>
internal sealed partial class CoordinateRowView : UserControl
{
    public CoordinateRowView() => InitializeComponent();
}
