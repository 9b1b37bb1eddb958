using Avalonia;
using Avalonia.Controls;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>Shows a screen, which comes part by part: keys and taps go before what is left of it.</summary>
public sealed class ScreenHost : Decorator
{
    /// <summary>The screen's view model; null for none.</summary>
    public static readonly StyledProperty<object?> ScreenProperty = AvaloniaProperty.Register<ScreenHost, object?>(nameof(Screen));

    // A part with fewer controls than that is laid out in less time than the others take to be laid out once more around it.
    private const int Least = 8;

    private static readonly Views Views = new();
    private Unfolding? _unfolding;

    /// <summary>The screen's view model; null for none.</summary>
    public object? Screen
    {
        get => GetValue(ScreenProperty);
        set => SetValue(ScreenProperty, value);
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        base.OnPropertyChanged(change);
        if (change?.Property == ScreenProperty)
        {
            Show(change.NewValue);
        }
    }

    private void Show(object? screen)
    {
        var view = Views.Build(screen, Child);
        view?.DataContext = screen;
        if (view == Child)
        {
            return;
        }

        _unfolding = view is null ? null : new(view, Least);
        Child = view;
        Unfold(_unfolding);
    }

    private void Unfold(Unfolding? unfolding)
    {
        if (unfolding?.Coming is null)
        {
            return;
        }

        Dispatcher.UIThread.Post(
            () =>
            {
                // Another screen may have been opened meanwhile.
                if (unfolding == _unfolding)
                {
                    unfolding.Next();
                    Unfold(unfolding);
                }
            },
            DispatcherPriority.Background);
    }
}
