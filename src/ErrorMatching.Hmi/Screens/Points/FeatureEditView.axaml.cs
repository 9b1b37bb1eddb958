using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The controls to name, move up or remove a feature, and to set its numbers of points.</summary>
internal sealed partial class FeatureEditView : UserControl
{
    public FeatureEditView() => InitializeComponent();
}
