using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A field that is typed into, with its name above and what is wrong below.</summary>
public sealed partial class TextFieldView : UserControl
{
    /// <summary>The view.</summary>
    public TextFieldView() => InitializeComponent();
}
