using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A text field with its name above; marked if it has a problem.</summary>
internal sealed partial class TextFieldView : StackPanel
{
    public TextFieldView() => InitializeComponent();

    protected override Type StyleKeyOverride => typeof(StackPanel);
}
