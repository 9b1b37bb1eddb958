using System.ComponentModel;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Styling;
using Avalonia.Threading;

namespace ErrorMatching.Hmi;

/// <summary>The station's window.</summary>
public sealed partial class MainWindow : Window
{
    private ShellViewModel? _shell;
    private InputElement? _focused;
    private ScannedCode? _code;

    /// <summary>A window of 1280 by 800, which is the smallest that everything fits into.</summary>
    public MainWindow()
    {
        InitializeComponent();
        AddHandler(PointerPressedEvent, (_, _) => _shell?.Touch(), RoutingStrategies.Tunnel, handledEventsToo: true);
        AddHandler(KeyDownEvent, (_, _) => _shell?.Touch(), RoutingStrategies.Tunnel, handledEventsToo: true);
        AddHandler(TextInputEvent, OnScannedText, RoutingStrategies.Tunnel);
        AddHandler(KeyDownEvent, OnScannedKey, RoutingStrategies.Tunnel);
    }

    /// <inheritdoc/>
    protected override void OnDataContextChanged(EventArgs e)
    {
        base.OnDataContextChanged(e);
        if (_shell is not null)
        {
            _shell.PropertyChanged -= OnShell;
        }

        _shell = DataContext as ShellViewModel;
        if (_shell is not null)
        {
            _shell.PropertyChanged += OnShell;
            _code = new(_shell.Station.Clock);
            ShowTheme();
            ShowTargets();
        }
    }

    /// <inheritdoc/>
    protected override void OnClosed(EventArgs e)
    {
        if (_shell is not null)
        {
            _shell.PropertyChanged -= OnShell;
        }

        base.OnClosed(e);
    }

    private void OnShell(object? sender, PropertyChangedEventArgs e)
    {
        if (e.PropertyName is nameof(ShellViewModel.IsDark))
        {
            ShowTheme();
        }
        else if (e.PropertyName is nameof(ShellViewModel.TouchSize))
        {
            ShowTargets();
        }
        else if (e.PropertyName is nameof(ShellViewModel.IsFree))
        {
            KeepFocus();
        }
    }

    private bool IsFieldless => FocusManager?.GetFocusedElement() is not TextBox;

    private void OnScannedText(object? sender, TextInputEventArgs e)
    {
        if (IsFieldless && e.Text is { } text)
        {
            _code?.Add(text);
        }
    }

    private void OnScannedKey(object? sender, KeyEventArgs e)
    {
        if (e.Key is Key.Enter && IsFieldless && _code?.End() is { } code)
        {
            _shell!.Scan(code);
            e.Handled = true;
        }
    }

    // What lies in front takes the focus; behind it, whoever goes by keyboard goes on where it was.
    private void KeepFocus()
    {
        if (!_shell!.IsFree)
        {
            _focused = FocusManager?.GetFocusedElement() as InputElement ?? _focused;
        }
        else if (_focused is { } before)
        {
            _focused = null;
            Dispatcher.UIThread.Post(() => before.Focus(), DispatcherPriority.Loaded);
        }
    }

    // The styles look the height up from where a control is: the window's own goes before the application's.
    private void ShowTargets() => Resources["Target"] = Resources["RowHeight"] = Application.Current!.FindResource("Target" + _shell!.TouchSize);

    private void ShowTheme() => RequestedThemeVariant = _shell!.IsDark ? ThemeVariant.Dark : ThemeVariant.Light;
}
