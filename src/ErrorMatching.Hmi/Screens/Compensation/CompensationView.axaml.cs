using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The pending change, and the decision about it.</summary>
public sealed partial class CompensationView : UserControl
{
    public CompensationView() => InitializeComponent();
}
