using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A field that something is chosen in, with its name above and what is wrong below.</summary>
public sealed partial class ChoiceFieldView : StackPanel
{
    /// <summary>The view.</summary>
    public ChoiceFieldView() => InitializeComponent();

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(StackPanel);
}
