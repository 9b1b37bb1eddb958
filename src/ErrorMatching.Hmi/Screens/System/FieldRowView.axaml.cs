using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Fields beside each other.</summary>
public sealed partial class FieldRowView : UserControl
{
    /// <summary>The view.</summary>
    public FieldRowView() => InitializeComponent();
}
