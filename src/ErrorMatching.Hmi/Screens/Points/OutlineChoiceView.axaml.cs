using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The outline of a drawing over the path of a program, before a job takes it.</summary>
internal sealed partial class OutlineChoiceView : UserControl
{
    public OutlineChoiceView() => InitializeComponent();
}
