using System.ComponentModel;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Layout;
using Avalonia.Styling;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

public sealed partial class MainWindow : Window
{
    private static readonly TimeSpan Quiet = TimeSpan.FromMilliseconds(200);
    private readonly FocusKeeper _focus;
    private readonly DispatcherTimer _tidying;
    private ShellViewModel? _shell;
    private ScannedCode? _code;

    /// <summary>A window of 1280 by 800, the smallest size that everything fits into.</summary>
    public MainWindow()
    {
        InitializeComponent();
        _tidying = new(Quiet, DispatcherPriority.ApplicationIdle, (_, _) => OnQuiet());
        _tidying.Stop();
        _focus = new(this);

        // Order matters: the first handler sees a tap last, and so sees what the others made of it.
        _ = new TapKeeper(this);
        _ = new TwiceKeeper(this);
        Aim = new(this);
        AddHandler(PointerPressedEvent, (_, _) => Touch(isByKeyboard: false), RoutingStrategies.Tunnel, handledEventsToo: true);
        AddHandler(KeyDownEvent, (_, _) => Touch(isByKeyboard: true), RoutingStrategies.Tunnel, handledEventsToo: true);
        AddHandler(TextInputEvent, OnScannedText, RoutingStrategies.Tunnel);
        AddHandler(KeyDownEvent, OnScannedKey, RoutingStrategies.Tunnel);
        Texts.Current.LanguageChanged += LayOutAnew;
    }

    /// <summary>True if the last input came from the keyboard, not from a pointer or finger.</summary>
    internal bool IsByKeyboard { get; private set; }

    /// <summary>Prevents taps from hitting rows that have just moved.</summary>
    internal AimKeeper Aim { get; }

    /// <summary>Collects garbage when a screen is complete and the user is idle. Otherwise the collection comes while the next
    /// screen opens, and takes up to half of that time.</summary>
    internal static void Tidy() => GC.Collect(1, GCCollectionMode.Forced, blocking: true);

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
    protected override void OnClosing(WindowClosingEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnClosing(e);

        // Only a user is asked: the system does not wait for an answer, nor does another program that ends this one.
        if (!e.IsProgrammatic && e.CloseReason == WindowCloseReason.WindowClosing && _shell?.MayClose(Close) == false)
        {
            e.Cancel = true;
        }
    }

    /// <inheritdoc/>
    protected override void OnClosed(EventArgs e)
    {
        if (_shell is not null)
        {
            _shell.PropertyChanged -= OnShell;
        }

        Texts.Current.LanguageChanged -= LayOutAnew;
        _tidying.Stop();
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
            _focus.Cover(_shell!.IsFree);
        }
        else if (e.PropertyName is nameof(ShellViewModel.Current))
        {
            Aim.Leave();
            _tidying.Stop();
            _tidying.Start();
        }
    }

    private void OnQuiet()
    {
        _tidying.Stop();
        Tidy();
    }

    private void Touch(bool isByKeyboard)
    {
        IsByKeyboard = isByKeyboard;
        _shell?.Touch();
    }

    // A panel does not rearrange its children if its own size changed in the same layout pass as their text (Avalonia 12.1): tabs
    // and cards would keep the widths of the previous language.
    private void LayOutAnew()
    {
        foreach (var control in this.GetVisualDescendants().OfType<Layoutable>())
        {
            control.InvalidateMeasure();
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

    // Styles look up the height from the control upwards: the window's resource overrides the application's.
    private void ShowTargets()
    {
        Resources["Target"] = Resources["RowHeight"] = Application.Current!.FindResource("Target" + _shell!.TouchSize);
        foreach (var key in new[] { "PlotLeast", "ProgramRow", "NoticeHeight" })
        {
            Resources[key] = Application.Current!.FindResource(key + _shell!.TouchSize);
        }
    }

    private void ShowTheme() => RequestedThemeVariant = _shell!.IsDark ? ThemeVariant.Dark : ThemeVariant.Light;
}
