using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Where a feature is named, moved up or removed, and its points are counted.</summary>
public sealed partial class FeatureEditView : UserControl
{
    /// <summary>The view.</summary>
    public FeatureEditView() => InitializeComponent();
}
