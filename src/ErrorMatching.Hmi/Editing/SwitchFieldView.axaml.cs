using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A field that is on or off.</summary>
internal sealed partial class SwitchFieldView : UserControl
{
    public SwitchFieldView() => InitializeComponent();
}
