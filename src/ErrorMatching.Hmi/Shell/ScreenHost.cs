using Avalonia;
using Avalonia.Controls;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Shows a screen, or what is looked at on one, which comes part by part: keys and taps go before what is left of it.</summary>
public sealed class ScreenHost : Decorator
{
    /// <summary>Its view model; null for none.</summary>
    public static readonly StyledProperty<object?> ScreenProperty = AvaloniaProperty.Register<ScreenHost, object?>(nameof(Screen));

    // A part with fewer controls than that is laid out in less time than the others take to be laid out once more around it.
    private const int Least = 8;

    private static readonly Views Views = new();
    private Unfolding? _unfolding;
    private bool _isAwaited;

    /// <summary>Its view model; null for none.</summary>
    public object? Screen
    {
        get => GetValue(ScreenProperty);
        set => SetValue(ScreenProperty, value);
    }

    /// <summary>Makes what nobody could see before: a host within a part waits until that comes.</summary>
    public override void ApplyTemplate()
    {
        base.ApplyTemplate();
        if (_isAwaited)
        {
            Show();
        }
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        base.OnPropertyChanged(change);
        if (change?.Property != ScreenProperty)
        {
            return;
        }

        // What is seen is replaced at once: nobody acts on what is gone.
        if (Child is not null || (VisualRoot is not null && IsEffectivelyVisible))
        {
            Show();
        }
        else
        {
            _isAwaited = true;
            InvalidateMeasure();
        }
    }

    private void Show()
    {
        _isAwaited = false;
        var view = Views.Build(Screen, Child);
        view?.DataContext = Screen;
        if (view == Child)
        {
            return;
        }


        // What is done for the first time takes longer.
        _unfolding = view is null ? null : new(view, this.FindAncestorOfType<Stage>() is null ? Least : 0);
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
