using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The controls to set the number of points of a flank, or of a whole feature.</summary>
internal sealed partial class FlankEditView : UserControl
{
    public FlankEditView() => InitializeComponent();
}
