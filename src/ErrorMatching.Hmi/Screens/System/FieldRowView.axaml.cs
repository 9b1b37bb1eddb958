using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Fields beside each other.</summary>
public sealed partial class FieldRowView : Border
{
    /// <summary>The view.</summary>
    public FieldRowView() => InitializeComponent();

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(Border);
}
