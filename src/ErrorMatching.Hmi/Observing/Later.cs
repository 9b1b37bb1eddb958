using System.Collections;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>Rows that come once the rest of a screen is drawn: neither of the two keeps whoever taps waiting for long.</summary>
public static class Later
{
    /// <summary>The rows of a list, instead of <see cref="ItemsControl.ItemsSource"/>.</summary>
    public static readonly AttachedProperty<IEnumerable?> RowsProperty = AvaloniaProperty.RegisterAttached<ItemsControl, IEnumerable?>("Rows", typeof(Later));

    static Later() => RowsProperty.Changed.AddClassHandler<ItemsControl>((list, _) =>
    {
        if (list.ItemsSource is null)
        {
            Dispatcher.UIThread.Post(() => list.ItemsSource = GetRows(list), DispatcherPriority.Background);
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
}
