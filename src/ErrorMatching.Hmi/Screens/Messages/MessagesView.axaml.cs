using Avalonia.Controls;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>Current messages and the audit trail.</summary>
internal sealed partial class MessagesView : UserControl
{
    // Share of the height for messages, however many: the audit trail needs room as well, and no button above it moves.
    private const double ShareOfNow = 1.0 / 3;

    public MessagesView() => InitializeComponent();

    /// <inheritdoc/>
    protected override void OnSizeChanged(SizeChangedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnSizeChanged(e);
        Now.Height = ShareOfNow * e.NewSize.Height;
    }

    private void OnMessage(object? sender, RoutedEventArgs e)
    {
        if ((sender as Control)?.DataContext is MessageRow message && DataContext is MessagesViewModel messages)
        {
            messages.Look(message);
        }
    }
}
