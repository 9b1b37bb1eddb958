using System.Collections;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Layout;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>Rows that come once the rest of a screen is drawn, and those of a list box a few at a time, as many as it has room for: none of it keeps whoever taps waiting for long.</summary>
public static class Later
{
    // A list box makes the rows that are seen: it gets its room in so many parts.
    private const int Parts = 3;

    /// <summary>The rows of a list, instead of <see cref="ItemsControl.ItemsSource"/>.</summary>
    public static readonly AttachedProperty<IEnumerable?> RowsProperty = AvaloniaProperty.RegisterAttached<ItemsControl, IEnumerable?>("Rows", typeof(Later));

    static Later() => RowsProperty.Changed.AddClassHandler<ItemsControl>((list, _) =>
    {
        if (list.ItemsSource is null)
        {
            Dispatcher.UIThread.Post(() => GiveWhenSeen(list), DispatcherPriority.Background);
        }
        else
        {
            list.ItemsSource = GetRows(list);
        }
    });

    /// <summary>The rows of a list.</summary>
    public static IEnumerable? GetRows(ItemsControl list) => (list ?? throw new ArgumentNullException(nameof(list))).GetValue(RowsProperty);

    /// <summary>Gives a list its rows: the first ones soon, others at once.</summary>
    public static void SetRows(ItemsControl list, IEnumerable? rows) => (list ?? throw new ArgumentNullException(nameof(list))).SetValue(RowsProperty, rows);

    // Its room is known from when it is first laid out.
    private static void GiveWhenSeen(ItemsControl list)
    {
        list.LayoutUpdated -= OnLaidOut;
        if (list.IsEffectivelyVisible && list.IsArrangeValid)
        {
            GiveRoom(list, list.Bounds.Height, 1);
            list.ItemsSource = GetRows(list);
        }
        else
        {
            list.LayoutUpdated += OnLaidOut;
        }
    }

    private static void OnLaidOut(object? sender, EventArgs e) => Dispatcher.UIThread.Post(() => GiveWhenSeen((ItemsControl)sender!), DispatcherPriority.Background);

    private static void GiveRoom(ItemsControl list, double room, int parts)
    {
        if (list is not ListBox || room <= 0 || parts == Parts)
        {
            list.ClearValue(Layoutable.MaxHeightProperty);
            list.ClearValue(Layoutable.VerticalAlignmentProperty);
            return;
        }

        (list.VerticalAlignment, list.MaxHeight) = (VerticalAlignment.Top, room * parts / Parts);
        Dispatcher.UIThread.Post(() => GiveRoom(list, room, parts + 1), DispatcherPriority.Background);
    }
}
