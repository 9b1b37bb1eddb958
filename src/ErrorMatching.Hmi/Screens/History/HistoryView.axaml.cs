using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>Search for past corrections.</summary>
internal sealed partial class HistoryView : UserControl
{
    // Below this height, all fields would leave no room for results.
    private const double LowHeight = 520;

    private bool _isOpen;

    public HistoryView()
    {
        InitializeComponent();
        ShowFields();
    }

    /// <inheritdoc/>
    protected override void OnSizeChanged(SizeChangedEventArgs e)
    {
        base.OnSizeChanged(e);
        ShowFields();
    }

    /// <inheritdoc/>
    protected override void OnLoaded(RoutedEventArgs e)
    {
        base.OnLoaded(e);

        // A barcode scanner types into the focused field and ends with Enter. That starts the search, and the next code replaces
        // this one. Keyboard users keep their focus.
        if (TopLevel.GetTopLevel(this) is not MainWindow { IsByKeyboard: true })
        {
            Later.Focus(SerialBox);
        }

        SerialBox.AddHandler(KeyDownEvent, OnSerialKey, RoutingStrategies.Bubble, handledEventsToo: true);
    }

    private void OnMore(object? sender, RoutedEventArgs e) => Open(true);

    private void OnFewer(object? sender, RoutedEventArgs e) => Open(false);

    private void Open(bool isOpen)
    {
        _isOpen = isOpen;
        ShowFields();

        // The tapped button is hidden now; focus the one in its place.
        (isOpen ? Fewer : More).Focus();
    }

    private void ShowFields()
    {
        var isLow = Bounds.Height is > 0 and < LowHeight;
        (More.IsVisible, Fewer.IsVisible) = (isLow && !_isOpen, isLow && _isOpen);
        Fields.Classes.Set("few", isLow && !_isOpen);
        Acts.IsVisible = !isLow || _isOpen;
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
