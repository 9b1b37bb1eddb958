using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>What is wrong with a field, or where nothing is typed.</summary>
public sealed partial class NoteFieldView : DockPanel
{
    /// <summary>The view.</summary>
    public NoteFieldView() => InitializeComponent();

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(DockPanel);
}
