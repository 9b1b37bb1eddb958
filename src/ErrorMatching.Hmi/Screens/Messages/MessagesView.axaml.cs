using Avalonia.Controls;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>Alarms, what waits, and the audit trail.</summary>
internal sealed partial class MessagesView : UserControl
{
    public MessagesView() => InitializeComponent();

    private void OnMessage(object? sender, RoutedEventArgs e) => With(sender, (screen, message) => screen.Look(message));

    private void OnAcknowledge(object? sender, RoutedEventArgs e) => With(sender, (screen, message) => screen.Acknowledge(message));

    private void OnShelve(object? sender, RoutedEventArgs e) => With(sender, (screen, message) => screen.Offer(message));

    private void OnHalfHour(object? sender, RoutedEventArgs e) =>
        With(sender, (screen, message) => screen.Shelve(message, TimeSpan.FromMinutes(30)));

    private void OnTwoHours(object? sender, RoutedEventArgs e) =>
        With(sender, (screen, message) => screen.Shelve(message, TimeSpan.FromHours(2)));

    private void OnShift(object? sender, RoutedEventArgs e) =>
        With(sender, (screen, message) => screen.Shelve(message, TimeSpan.FromHours(8)));

    private void OnBringBack(object? sender, RoutedEventArgs e) => With(sender, (screen, message) => screen.Unshelve(message));

    private void With(object? sender, Action<MessagesViewModel, MessageRow> act)
    {
        if ((sender as Control)?.DataContext is MessageRow message && DataContext is MessagesViewModel screen)
        {
            act(screen, message);
        }
    }
}
