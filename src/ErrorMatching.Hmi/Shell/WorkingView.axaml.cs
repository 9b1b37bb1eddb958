using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Shows that a long operation is running, with a way to cancel it.</summary>
internal sealed partial class WorkingView : UserControl
{
    public WorkingView() => InitializeComponent();
}
