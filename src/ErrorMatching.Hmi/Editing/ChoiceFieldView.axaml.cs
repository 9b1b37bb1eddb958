using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A choice field with its name above and its problem below.</summary>
internal sealed partial class ChoiceFieldView : StackPanel
{
    public ChoiceFieldView() => InitializeComponent();

    protected override Type StyleKeyOverride => typeof(StackPanel);
}
