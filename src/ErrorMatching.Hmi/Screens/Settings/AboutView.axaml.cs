using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Where the station says what it is.</summary>
public sealed partial class AboutView : UserControl
{
    /// <summary>The view.</summary>
    public AboutView() => InitializeComponent();
}
