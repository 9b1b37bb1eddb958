using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Something that takes its time, as long as it does: that it goes on, and the way to cancel it.</summary>
public sealed partial class WorkingView : UserControl
{
    /// <summary>The view.</summary>
    public WorkingView() => InitializeComponent();
}
