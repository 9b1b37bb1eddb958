using System.ComponentModel;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Interactivity;
using Avalonia.Layout;
using Avalonia.Platform;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

public sealed partial class MainWindow : Window
{
    // Below this width, rail and lists are narrower.
    private const double NarrowWidth = 1200;

    private static readonly TimeSpan Quiet = TimeSpan.FromMilliseconds(200);
    private readonly FocusKeeper _focus;
    private readonly DispatcherTimer _tidying;
    private readonly KeyboardKeeper _keyboard;
    private readonly TypingKeeper _typing;
    private ShellViewModel? _shell;
    private bool _isLocked = true;

    /// <summary>A window of 1280 by 800, the smallest size that everything fits into.</summary>
    public MainWindow()
    {
        InitializeComponent();
        _tidying = new(Quiet, DispatcherPriority.ApplicationIdle, (_, _) => OnQuiet());
        _tidying.Stop();
        _focus = new(this);

        // Order matters: the first handler sees a tap last, and so sees what the others made of it.
        _ = new TapKeeper(this);
        _ = new SecondTapGuard(this);
        Aim = new(this);
        _keyboard = new(this, Keyboard, Whole);
        AddHandler(PointerPressedEvent, (_, _) => Touch(isByKeyboard: false), RoutingStrategies.Tunnel, handledEventsToo: true);
        AddHandler(KeyDownEvent, (_, _) => Touch(isByKeyboard: !Keyboard.IsActing), RoutingStrategies.Tunnel, handledEventsToo: true);
        _typing = new(this);
        Texts.Current.LanguageChanged += LayOutAnew;
        Application.Current!.PlatformSettings?.ColorValuesChanged += OnSystemColors;
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
            ShowTheme();
            ShowTargets();
        }
    }

    /// <inheritdoc/>
    protected override void OnSizeChanged(SizeChangedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnSizeChanged(e);
        var isNarrow = e.NewSize.Width < NarrowWidth;
        if (isNarrow != Classes.Contains("narrow"))
        {
            Classes.Set("narrow", isNarrow);
            foreach (var key in new[] { "RailWidth", "ListWidth" })
            {
                Resources[key] = Application.Current!.FindResource(key + (isNarrow ? "Narrow" : "Wide"));
            }
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
        Application.Current!.PlatformSettings?.ColorValuesChanged -= OnSystemColors;
        _tidying.Stop();
        _typing.Close();
        base.OnClosed(e);
    }

    private void OnShell(object? sender, PropertyChangedEventArgs e)
    {
        _typing.Follow();
        if (_shell!.IsLocked != _isLocked)
        {
            _isLocked = !_isLocked;
            _keyboard.Leave();
        }

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
            _keyboard.Leave();
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

    // Styles look up the height from the control upwards: the window's resource overrides the application's.
    private void ShowTargets()
    {
        Resources["Target"] = Resources["RowHeight"] = Application.Current!.FindResource("Target" + _shell!.TouchSize);
        foreach (var key in new[] { "PlotLeast", "ProgramRow", "NoticeHeight", "SidesLeast" })
        {
            Resources[key] = Application.Current!.FindResource(key + _shell!.TouchSize);
        }
    }

    private void OnSystemColors(object? sender, PlatformColorValues e) => ShowTheme();

    private void ShowTheme() =>
        RequestedThemeVariant = HighContrast.Theme(_shell?.IsDark == true, Application.Current!.PlatformSettings?.GetColorValues());
}
