using Avalonia.Controls;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>What happened, and the record of it.</summary>
public sealed partial class MessagesView : UserControl
{
    /// <summary>The view.</summary>
    public MessagesView() => InitializeComponent();

    private void OnMessage(object? sender, RoutedEventArgs e)
    {
        if ((sender as Control)?.DataContext is MessageRow { Correction: { } correction } && DataContext is MessagesViewModel messages)
        {
            messages.Look(correction);
        }
    }
}
