using System.Collections;
using System.Collections.Specialized;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Layout;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>Adds rows after the rest of a screen is drawn, those of a list box in batches, so that none delays a tap for long.</summary>
public static class Later
{
    // The rest of the screen comes first: the room for a list depends on it.
    private static readonly DispatcherPriority After = DispatcherPriority.ApplicationIdle;

    // A list box creates the visible rows, so it gets its room in this many parts.
    private const int Parts = 3;

    /// <summary>The rows of a list, instead of <see cref="ItemsControl.ItemsSource"/>.</summary>
    public static readonly AttachedProperty<IEnumerable?> RowsProperty = AvaloniaProperty.RegisterAttached<ItemsControl, IEnumerable?>(
        "Rows", typeof(Later));

    static Later() => RowsProperty.Changed.AddClassHandler<ItemsControl>((list, _) =>
    {
        if (list.ItemsSource is null)
        {
            Dispatcher.UIThread.Post(() => GiveWhenSeen(list), After);
        }
        else
        {
            list.ItemsSource = GetRows(list);
        }
    });

    public static IEnumerable? GetRows(ItemsControl list) => (list ?? throw new ArgumentNullException(nameof(list))).GetValue(RowsProperty);

    /// <summary>Sets the rows of a list: the first ones after the screen is drawn, later changes at once.</summary>
    public static void SetRows(ItemsControl list, IEnumerable? rows) =>
        (list ?? throw new ArgumentNullException(nameof(list))).SetValue(RowsProperty, rows);

    /// <summary>Focuses a control as soon as it is visible, because a screen appears part by part.</summary>
    public static void Focus(InputElement control)
    {
        ArgumentNullException.ThrowIfNull(control);
        if (control.IsEffectivelyVisible)
        {
            control.Focus();
            return;
        }

        control.PropertyChanged += OnProperty;
        control.DetachedFromVisualTree += OnDetached;

        void OnProperty(object? sender, AvaloniaPropertyChangedEventArgs e)
        {
            if (e.Property == Visual.BoundsProperty)
            {
                End();
                control.Focus();
            }
        }

        void OnDetached(object? sender, VisualTreeAttachmentEventArgs e) => End();

        void End()
        {
            control.PropertyChanged -= OnProperty;
            control.DetachedFromVisualTree -= OnDetached;
        }
    }

    // Its room is known after its first layout.
    private static void GiveWhenSeen(ItemsControl list)
    {
        list.LayoutUpdated -= OnLaidOut;
        if (list.IsEffectivelyVisible && list.IsArrangeValid)
        {
            list.ItemsSource = GetRows(list);
            GiveRoom(list, list.Bounds.Height, 1);
        }
        else
        {
            list.LayoutUpdated += OnLaidOut;
        }
    }

    private static void OnLaidOut(object? sender, EventArgs e) =>
        Dispatcher.UIThread.Post(() => GiveWhenSeen((ItemsControl)sender!), After);

    private static void GiveRoom(ItemsControl list, double room, int parts)
    {
        if (list is not ListBox || room <= 0 || parts == Parts)
        {
            list.ClearValue(Layoutable.MaxHeightProperty);
            list.ClearValue(Layoutable.VerticalAlignmentProperty);
            return;
        }

        (list.VerticalAlignment, list.MaxHeight) = (VerticalAlignment.Top, room * parts / Parts);
        if (list.ItemsSource is INotifyCollectionChanged rows && list.ItemCount == 0)
        {
            WhenFilled(rows, () => GiveRoom(list, room, parts + 1));
        }
        else
        {
            Dispatcher.UIThread.Post(() => GiveRoom(list, room, parts + 1), After);
        }
    }

    // Rows read in the background arrive after the list is created.
    private static void WhenFilled(INotifyCollectionChanged rows, Action go)
    {
        rows.CollectionChanged += OnRows;

        void OnRows(object? sender, NotifyCollectionChangedEventArgs e)
        {
            rows.CollectionChanged -= OnRows;
            Dispatcher.UIThread.Post(go, After);
        }
    }
}
