using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A field that is typed into, with its name above; it is marked where something is wrong.</summary>
public sealed partial class TextFieldView : StackPanel
{
    /// <summary>The view.</summary>
    public TextFieldView() => InitializeComponent();

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(StackPanel);
}
