using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Fields side by side.</summary>
public sealed partial class FieldRowView : Border
{
    public FieldRowView() => InitializeComponent();

    protected override Type StyleKeyOverride => typeof(Border);
}
