using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Media;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>Opens the keyboard on the screen when a finger has led to a field, and moves the screen up so that the keyboard never covers
/// that field. A key of another keyboard closes it.</summary>
internal sealed class KeyboardKeeper
{
    private readonly MainWindow _window;
    private readonly ScreenKeyboard _board;
    private bool _isByFinger;
    private bool _isDown;

    /// <summary>Watches the fields of a window.</summary>
    /// <param name="window">The window.</param>
    /// <param name="board">Its keyboard.</param>
    /// <param name="content">All of the window besides the keyboard.</param>
    public KeyboardKeeper(MainWindow window, ScreenKeyboard board, Panel content)
    {
        (_window, _board, Content) = (window, board, content);
        board.IsVisible = false;
        board.Closed += Leave;
        window.AddHandler(InputElement.PointerPressedEvent, OnPressed, RoutingStrategies.Tunnel, handledEventsToo: true);
        window.AddHandler(InputElement.PointerReleasedEvent, (_, _) => OnLifted(), RoutingStrategies.Bubble, handledEventsToo: true);
        window.AddHandler(InputElement.PointerCaptureLostEvent, (_, _) => OnLifted(), RoutingStrategies.Bubble, handledEventsToo: true);
        window.AddHandler(InputElement.GotFocusEvent, (_, _) => FollowLater());
        window.AddHandler(InputElement.LostFocusEvent, (_, _) => FollowLater());
        window.AddHandler(InputElement.KeyDownEvent, (_, _) => OnKey(), RoutingStrategies.Tunnel, handledEventsToo: true);
        window.LayoutUpdated += (_, _) => Move();
    }

    private Panel Content { get; }

    private KeyboardUse Use => (_window.DataContext as ShellViewModel)?.Preferences.Keyboard ?? KeyboardUse.Never;

    /// <summary>Closes the keyboard. It opens again when a finger leads to a field.</summary>
    public void Leave()
    {
        _isByFinger = false;
        Open(null);
    }

    private void OnPressed(object? sender, PointerPressedEventArgs e)
    {
        _isDown = true;
        if (!_board.IsActing && e.Source is Visual source && source != _board && !_board.IsVisualAncestorOf(source))
        {
            _isByFinger = Use == KeyboardUse.Always || (Use == KeyboardUse.Finger && e.Pointer.Type != PointerType.Mouse);
        }
    }

    // A field must not move away under the finger that touches it.
    private void OnLifted()
    {
        _isDown = false;
        FollowLater();
    }

    private void OnKey()
    {
        if (!_board.IsActing)
        {
            Leave();
        }
    }

    // After the events that belong together: focus is lost before it is gained.
    private void FollowLater() => Dispatcher.UIThread.Post(Follow, DispatcherPriority.Input);

    private void Follow()
    {
        if (_window.FocusManager?.GetFocusedElement() is TextBox { IsReadOnly: false, IsEffectivelyEnabled: true } field)
        {
            if (_isByFinger && !_isDown)
            {
                Open(field);
            }
        }
        else
        {
            Open(null);
        }
    }

    private void Open(TextBox? field)
    {
        _board.Field = field;
        Move();
    }

    // Up to where the field is just above the keyboard, but not so far that its top is gone.
    private void Move()
    {
        var up = 0.0;
        if (_board is { Field: { } field, Bounds.Height: > 0 and var height }
            && field.TranslatePoint(default, Content) is { } corner)
        {
            var gap = (double)_window.FindResource("GapSmall")!;
            var below = corner.Y + field.Bounds.Height + gap - (Content.Bounds.Height - height);
            up = Math.Max(0, Math.Min(below, corner.Y - gap));
        }

        if (up != ((Content.RenderTransform as TranslateTransform)?.Y is { } y ? -y : 0))
        {
            Content.RenderTransform = up == 0 ? null : new TranslateTransform(0, -up);
        }
    }
}
