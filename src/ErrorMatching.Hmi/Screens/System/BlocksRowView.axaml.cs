using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A feature's name, to pick blocks for it, and the field of its blocks.</summary>
public sealed partial class BlocksRowView : Border
{
    /// <summary>The view.</summary>
    public BlocksRowView() => InitializeComponent();

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(Border);
}
