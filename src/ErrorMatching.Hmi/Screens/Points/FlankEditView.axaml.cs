using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Where the points of a flank, or of all of a feature, are counted.</summary>
public sealed partial class FlankEditView : UserControl
{
    /// <summary>The view.</summary>
    public FlankEditView() => InitializeComponent();
}
