using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A feature's name, the button to pick blocks for it, and the field for its blocks.</summary>
internal sealed partial class BlocksRowView : Border
{
    public BlocksRowView() => InitializeComponent();

    protected override Type StyleKeyOverride => typeof(Border);
}
