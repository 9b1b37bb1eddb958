using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Where language, theme and sizes are chosen.</summary>
public sealed partial class LookView : UserControl
{
    /// <summary>The view.</summary>
    public LookView() => InitializeComponent();
}
