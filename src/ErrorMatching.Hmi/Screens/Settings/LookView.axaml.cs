using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Choice of language, theme and sizes.</summary>
internal sealed partial class LookView : UserControl
{
    public LookView() => InitializeComponent();
}
