using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The problem of a field, or of a place without input.</summary>
internal sealed partial class NoteFieldView : DockPanel
{
    public NoteFieldView() => InitializeComponent();

    protected override Type StyleKeyOverride => typeof(DockPanel);
}
