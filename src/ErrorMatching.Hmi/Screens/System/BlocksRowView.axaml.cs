using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A feature's name, to pick blocks for it, and the field of its blocks.</summary>
public sealed partial class BlocksRowView : UserControl
{
    /// <summary>The view.</summary>
    public BlocksRowView() => InitializeComponent();
}
