using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Which job is edited, the way back, what is wrong, and saving: above both set-up screens.</summary>
public sealed partial class SetupBar : UserControl
{
    /// <summary>The view.</summary>
    public SetupBar() => InitializeComponent();
}
