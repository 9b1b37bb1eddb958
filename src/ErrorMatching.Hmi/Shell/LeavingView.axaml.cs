using Avalonia.Controls;

namespace ErrorMatching.Hmi;

internal sealed partial class LeavingView : UserControl
{
    public LeavingView() => InitializeComponent();
}
