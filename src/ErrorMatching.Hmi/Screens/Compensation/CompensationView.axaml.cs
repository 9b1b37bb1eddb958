using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The pending change, and the decision about it.</summary>
internal sealed partial class CompensationView : UserControl
{
    public CompensationView() => InitializeComponent();
}
