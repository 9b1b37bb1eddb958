using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>One piece: its errors, its assembly, what became better, and the pieces before it.</summary>
public sealed partial class PieceDetailView : UserControl
{
    /// <summary>The view.</summary>
    public PieceDetailView() => InitializeComponent();
}
