using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Whether the compensation worked as predicted.</summary>
public sealed partial class VerificationView : UserControl
{
    public VerificationView() => InitializeComponent();
}
