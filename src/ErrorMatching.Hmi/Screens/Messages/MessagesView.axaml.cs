using Avalonia.Controls;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>What happened, and the record of it.</summary>
public sealed partial class MessagesView : UserControl
{
    // What there is to know has this of the height, however much it is: the record is read as well, and no button above it moves.
    private const double ShareOfNow = 1.0 / 3;

    /// <summary>The view.</summary>
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
