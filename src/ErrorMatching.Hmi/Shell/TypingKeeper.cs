using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Input.Raw;
using Avalonia.Interactivity;
using Avalonia.Threading;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Brings typed keys where they belong: to the focused field, to the dialog in front, to the code of a scanner, or nowhere. A
/// password that is typed too early or too late is shown nowhere and decides nothing.</summary>
internal sealed class TypingKeeper
{
    /// <summary>After a dialog or the login has closed, keys that were meant for it may come for this long.</summary>
    public static readonly TimeSpan Moment = TimeSpan.FromSeconds(1);

    private readonly MainWindow _window;
    private readonly ScannedCode _code = new();
    private readonly DispatcherTimer _moment;
    private readonly IDisposable? _times;
    private ulong _at;
    private bool _isOpen;
    private bool _isEscape;

    /// <summary>Watches the keys of a window while it is open.</summary>
    public TypingKeeper(MainWindow window)
    {
        _window = window;

        // Below the priority of input: keys that wait while the station is busy come before the end of the moment.
        _moment = new(Moment, DispatcherPriority.Background, (_, _) => _moment!.Stop());
        _moment.Stop();
        _times = AvaloniaLocator.Current.GetService<IInputManager>()?.PreProcess.Subscribe(new Times(e => _at = e.Timestamp));
        window.AddHandler(InputElement.TextInputEvent, OnText, RoutingStrategies.Tunnel);
        window.AddHandler(InputElement.KeyDownEvent, OnKey, RoutingStrategies.Tunnel);
        window.AddHandler(InputElement.PointerPressedEvent, (_, _) => _moment.Stop(), RoutingStrategies.Tunnel, handledEventsToo: true);
    }

    /// <summary>True while keys may come that were meant for what has just closed.</summary>
    internal bool IsOn => _moment.IsEnabled;

    private ShellViewModel? Shell => _window.DataContext as ShellViewModel;

    private int? LeastBadge => Shell is { ExpectsBadge: true } ? Session.LeastBadge : null;

    private Control? Focused => _window.FocusManager?.GetFocusedElement() as Control;

    /// <summary>Follows the shell: call it when one of its properties has changed.</summary>
    public void Follow()
    {
        var isOpen = Shell is { IsFree: true, IsLocked: false };
        if (isOpen && !_isOpen && !_isEscape)
        {
            _moment.Stop();
            _moment.Start();
        }

        if (isOpen != _isOpen || (!isOpen && Shell is not { ExpectsBadge: true }))
        {
            _code.Clear();
        }

        _isOpen = isOpen;
    }

    /// <summary>Call this when the window is closed.</summary>
    public void Close()
    {
        _moment.Stop();
        _times?.Dispose();
    }

    private void OnText(object? sender, TextInputEventArgs e)
    {
        if (IsMissed)
        {
            e.Handled = true;
        }
        else if (e.Text is { } text && !_window.Keyboard.IsActing && (Focused is not TextBox || Shell is { ExpectsBadge: true }))
        {
            // A badge that announces itself shows nowhere. Of another one, its end tells what it was: then the field is emptied.
            e.Handled = _code.IsAnnounced && Focused is TextBox;
            _code.Add(text, _at);
        }
    }

    private void OnKey(object? sender, KeyEventArgs e)
    {
        if (_window.Keyboard.IsActing)
        {
            // A finger on the screen is no scanner.
            return;
        }

        // Who leaves a dialog by Escape types no password.
        _isEscape = e.Key == Key.Escape;
        switch (e.Key)
        {
            // Moves the focus on purpose.
            case Key.Tab or Key.Up or Key.Down or Key.Left or Key.Right:
                _moment.Stop();
                break;
            case Key.Enter or Key.Space when IsMissed:
                e.Handled = true;
                break;
            case Key.F12 when e.KeyModifiers == KeyModifiers.None:
                _code.Announce(_at);
                e.Handled = true;
                break;
            case Key.Enter when (Focused is not TextBox || Shell is { ExpectsBadge: true }) && _code.End(_at, LeastBadge) is { } code:
                Shell?.Scan(code);
                e.Handled = true;
                break;
        }
    }

    // The screen behind a dialog does not have the focus, but the dialog may not have it yet; likewise the login.
    private bool IsMissed => Shell switch
    {
        null => false,
        { IsFree: false } => Focused is not { } focused
            || !focused.GetVisualAncestors().OfType<Panel>().Any(p => p.Classes.Contains("veil")),
        { IsLocked: true } => Focused is null,
        _ => _moment.IsEnabled,
    };

    private sealed class Times(Action<RawInputEventArgs> take) : IObserver<RawInputEventArgs>
    {
        public void OnNext(RawInputEventArgs value) => take(value);

        public void OnCompleted()
        {
            // Input ends with the program.
        }

        public void OnError(Exception error)
        {
            // Input has no errors.
        }
    }
}
