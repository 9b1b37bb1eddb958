using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Whether the compensation did what it promised.</summary>
public sealed partial class VerificationView : UserControl
{
    /// <summary>The view.</summary>
    public VerificationView() => InitializeComponent();
}
