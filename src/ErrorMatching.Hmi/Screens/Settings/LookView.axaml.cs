using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Choice of language, theme and sizes.</summary>
public sealed partial class LookView : UserControl
{
    public LookView() => InitializeComponent();
}
