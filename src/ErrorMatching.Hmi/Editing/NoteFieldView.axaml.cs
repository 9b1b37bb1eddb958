using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>What is wrong where nothing is typed.</summary>
public sealed partial class NoteFieldView : UserControl
{
    /// <summary>The view.</summary>
    public NoteFieldView() => InitializeComponent();
}
