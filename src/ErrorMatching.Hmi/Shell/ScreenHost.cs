using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Templates;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Shows a screen, or a detail of one, part by part: keys and taps have priority over the remaining parts.</summary>
internal sealed class ScreenHost : Decorator
{
    public static readonly StyledProperty<object?> ScreenProperty = AvaloniaProperty.Register<ScreenHost, object?>(nameof(Screen));

    // A part with fewer controls is laid out faster than the rest is laid out around it once more.
    private const int Least = 8;

    private Unfolding? _unfolding;
    private bool _isAwaited;

    /// <summary>An empty host.</summary>
    public ScreenHost() => Classes.Add("screen");

    /// <summary>Its view model; null for none.</summary>
    public object? Screen
    {
        get => GetValue(ScreenProperty);
        set => SetValue(ScreenProperty, value);
    }

    /// <summary>Creates the view when it first becomes visible: a host within a part waits until that part is shown.</summary>
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

        // Visible content is replaced at once, so that no one acts on outdated content.
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
        var view = ViewOf(Screen, Child);
        view?.DataContext = Screen;
        if (view == Child)
        {
            return;
        }


        // During the rehearsal, code runs for the first time and is slower, so even small parts get their own step.
        _unfolding = view is null ? null : new(view, this.FindAncestorOfType<Stage>() is null ? Least : 0);
        Child = view;
        Unfold(_unfolding);
    }

    // The application's templates know the views of all screens.
    private Control? ViewOf(object? content, Control? existing) => this.FindDataTemplate(content) switch
    {
        IRecyclingDataTemplate views => views.Build(content, existing),
        { } views => views.Build(content),
        null => null,
    };

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
