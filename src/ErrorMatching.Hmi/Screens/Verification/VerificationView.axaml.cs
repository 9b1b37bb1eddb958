using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Whether the compensation worked as predicted.</summary>
internal sealed partial class VerificationView : UserControl
{
    public VerificationView() => InitializeComponent();
}
