using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>Where what was is found.</summary>
public sealed partial class HistoryView : UserControl
{
    /// <summary>The view.</summary>
    public HistoryView() => InitializeComponent();

    /// <inheritdoc/>
    protected override void OnLoaded(RoutedEventArgs e)
    {
        base.OnLoaded(e);

        // A barcode scanner types into what has the focus, and ends with Enter: that searches, and the next code takes the place of this one.
        // Whoever goes through the screens by keyboard goes on from where they are.
        if (TopLevel.GetTopLevel(this) is not MainWindow { IsByKeyboard: true })
        {
            SerialBox.Focus();
        }

        SerialBox.AddHandler(KeyDownEvent, OnSerialKey, RoutingStrategies.Bubble, handledEventsToo: true);
    }

    private void OnSerialKey(object? sender, KeyEventArgs e)
    {
        if (e.Key is Key.Enter)
        {
            SerialBox.SelectAll();
        }
    }

    private void OnRowTapped(object? sender, TappedEventArgs e) => Open((e.Source as StyledElement)?.DataContext);

    private void OnRowKey(object? sender, KeyEventArgs e)
    {
        if (e.Key is Key.Enter or Key.Space)
        {
            Open((sender as ListBox)?.SelectedItem);
            e.Handled = true;
        }
    }

    private void Open(object? row)
    {
        if (row is HistoryRow found && DataContext is HistoryViewModel history)
        {
            history.LookAt(found.Id);
        }
    }
}
