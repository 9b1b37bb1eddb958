using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>One piece: its errors, its assembly, the improvement, and the trend.</summary>
internal sealed partial class PieceDetailView : UserControl
{
    public PieceDetailView() => InitializeComponent();
}
