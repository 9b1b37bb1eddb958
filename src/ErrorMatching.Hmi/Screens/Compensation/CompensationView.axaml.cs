using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>What will change, and the decision about it.</summary>
public sealed partial class CompensationView : UserControl
{
    /// <summary>The view.</summary>
    public CompensationView() => InitializeComponent();
}
