using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>The file chooser dialog.</summary>
internal sealed partial class FileChooserView : UserControl
{
    public FileChooserView()
    {
        InitializeComponent();

        // Before the lists themselves, which use Enter to select a row.
        PlaceList.AddHandler(KeyDownEvent, OnPlaceKey, RoutingStrategies.Tunnel);
        Entries.AddHandler(KeyDownEvent, OnRowKey, RoutingStrategies.Tunnel);
    }

    /// <inheritdoc/>
    protected override void OnLoaded(RoutedEventArgs e)
    {
        base.OnLoaded(e);
        if (DataContext is FileChooserViewModel chooser)
        {
            FocusFirst(chooser, null);
        }
    }

    private static T? Of<T>(RoutedEventArgs e)
        where T : class => (e.Source as StyledElement)?.DataContext as T;

    private void OnPlaceTapped(object? sender, TappedEventArgs e) => Go(Of<FolderPlace>(e));

    private void OnPlaceKey(object? sender, KeyEventArgs e)
    {
        if (e.Key is Key.Enter or Key.Space && (sender as ListBox)?.SelectedItem is FolderPlace place)
        {
            Go(place);
            e.Handled = true;
        }
    }

    private void OnRowTapped(object? sender, TappedEventArgs e)
    {
        if (Of<FolderEntry>(e) is { } entry)
        {
            (DataContext as FileChooserViewModel)?.Take(entry);
        }
    }

    // After a habitual double tap on a folder, another row is under the finger; it was not meant.
    private void OnRowDoubleTapped(object? sender, TappedEventArgs e)
    {
        if (Of<FolderEntry>(e) is { IsFolder: false })
        {
            OnRowTapped(sender, e);
        }
    }

    private void OnRowKey(object? sender, KeyEventArgs e)
    {
        if (DataContext is not FileChooserViewModel chooser)
        {
            return;
        }

        var before = chooser.Folder;
        if (e.Key is Key.Back && chooser.Up.CanExecute(null))
        {
            chooser.Up.Execute(null);
            FocusFirst(chooser, before);
            e.Handled = true;
        }
        else if (e.Key is Key.Enter or Key.Space && Of<FolderEntry>(e) is { } entry)
        {
            chooser.Take(entry);
            FocusFirst(chooser, before);
            e.Handled = true;
        }
    }

    private void Go(FolderPlace? place)
    {
        if (place is not null)
        {
            (DataContext as FileChooserViewModel)?.Enter(place.Path);
        }
    }

    // Keyboard users continue at the file in the field, else at the first row. Only the file in the field looks selected.
    private async void FocusFirst(FileChooserViewModel chooser, string? before)
    {
        await chooser.Loading;
        if (chooser.Folder != before)
        {
            var row = chooser.Chosen is { } chosen ? chooser.Rows.IndexOf(chosen) : -1;
            Entries.SelectedIndex = row;
            Dispatcher.UIThread.Post(
                () =>
                {
                    // A busy machine may not have laid the rows out yet; before that, they do not exist.
                    Entries.UpdateLayout();
                    (Entries.ContainerFromIndex(Math.Max(0, row)) ?? Entries).Focus(NavigationMethod.Directional);
                },
                DispatcherPriority.Loaded);
        }
    }
}
