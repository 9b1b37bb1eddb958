using Avalonia;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>A program as text and as a drawn path.</summary>
internal sealed partial class ProgramPictureView : UserControl
{
    public ProgramPictureView() => InitializeComponent();

    /// <inheritdoc/>
    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        Texts.Current.LanguageChanged += Translate;
    }

    /// <inheritdoc/>
    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnDetachedFromVisualTree(e);
        Texts.Current.LanguageChanged -= Translate;
    }

    private void Translate() => (DataContext as ProgramPicture)?.Translate();
}
