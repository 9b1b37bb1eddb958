using Avalonia.Controls;
using Avalonia.Input.Platform;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

/// <summary>The screen to enter and try out coordinates, blocks and limits.</summary>
internal sealed partial class SystemView : SetupView
{
    public SystemView()
    {
        InitializeComponent();
        PointList.AddHandler(TextBox.PastingFromClipboardEvent, OnPasting);
    }

    protected override void ShowRow(string id)
    {
        if (DataContext is SystemViewModel system && system.RowOf(id) is >= 0 and var row && row < PointList.ItemCount)
        {
            PointList.ScrollIntoView(row);
        }
    }

    private void OnPaste(object? sender, RoutedEventArgs e) => _ = PasteAsync(null).Watched();

    // A table pasted into a field fills all fields that it has coordinates for.
    private void OnPasting(object? sender, RoutedEventArgs e)
    {
        e.Handled = true;
        _ = PasteAsync(e.Source as TextBox).Watched();
    }

    private async Task PasteAsync(TextBox? box)
    {
        var text = TopLevel.GetTopLevel(this)?.Clipboard is { } clipboard ? await clipboard.TryGetTextAsync() : null;
        if (box is null || text?.AsSpan().Trim().IndexOfAny("\t\n") >= 0)
        {
            (DataContext as SystemViewModel)?.Paste(text);
        }
        else
        {
            box.SelectedText = text ?? "";
        }
    }
}
