using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Fields side by side.</summary>
internal sealed partial class FieldRowView : Border
{
    public FieldRowView() => InitializeComponent();

    protected override Type StyleKeyOverride => typeof(Border);
}
