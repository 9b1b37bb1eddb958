using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The head of a side of a screen.</summary>
public sealed partial class SideHeadView : StackPanel
{
    /// <summary>The view.</summary>
    public SideHeadView() => InitializeComponent();

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(StackPanel);
}
