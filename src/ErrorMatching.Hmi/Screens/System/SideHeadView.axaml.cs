using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The head of a tab.</summary>
internal sealed partial class SideHeadView : StackPanel
{
    public SideHeadView() => InitializeComponent();

    protected override Type StyleKeyOverride => typeof(StackPanel);
}
