using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A theoretical point: its feature, and fields for its label and its coordinates.</summary>
public sealed partial class CoordinateRowView : UserControl
{
    /// <summary>The view.</summary>
    public CoordinateRowView() => InitializeComponent();
}
