using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Markup.Xaml;

namespace ErrorMatching.Hmi;

public sealed partial class App : Application
{
    /// <summary>Opens the station on the UI thread; null if the caller creates the windows.</summary>
    public Func<Station>? Open { get; init; }

    /// <summary>Its initial appearance.</summary>
    public StationLook Look { get; init; } = new(Language.English, IsDark: false, IsFullScreen: false);

    /// <summary>Called with the duration if the UI thread was blocked for too long; null if this is not needed.</summary>
    public Action<TimeSpan>? Busy { get; init; }

    /// <inheritdoc/>
    public override void Initialize()
    {
        AvaloniaXamlLoader.Load(this);
        TabRow.Mend();
        WholeField.Mend();
    }

    /// <inheritdoc/>
    public override void OnFrameworkInitializationCompleted()
    {
        if (ApplicationLifetime is IClassicDesktopStyleApplicationLifetime desktop && Open is not null)
        {
            // The window is created while opening the station may still be busy creating its cell.
            Texts.Current.Language = Look.Language;
            if (Look.IsAndon)
            {
                OpenAndon(desktop, Open);
                base.OnFrameworkInitializationCompleted();
                return;
            }

            var window = new MainWindow { WindowState = Look.State };
            if (!Look.IsFullScreen)
            {
                window.MinWidth = (double)this.FindResource("WindowLeastWidth")!;
                window.MinHeight = (double)this.FindResource("WindowLeastHeight")!;
            }

            var station = Open();
            var shell = Screens.ShellOf(station);
            shell.IsDark = Look.IsDark;
            window.DataContext = shell;
            desktop.MainWindow = window;
            var end = new CancellationTokenSource();
            if (Busy is not null)
            {
                // The time to create the window is expected and not reported.
                window.Opened += (_, _) => _ = new ScreenWatch(
                    SynchronizationContext.Current!, TimeProvider.System, Busy).RunAsync(end.Token).Watched();
            }

            window.Opened += (_, _) => _ = new Rehearsal(window, shell).RunAsync(end.Token).Watched();
            desktop.Exit += (_, _) =>
            {
                end.Cancel();
                end.Dispose();
                shell.Dispose();
                station.Dispose();
            };
        }

        base.OnFrameworkInitializationCompleted();
    }

    private void OpenAndon(IClassicDesktopStyleApplicationLifetime desktop, Func<Station> open)
    {
        var window = new AndonWindow { IsDark = Look.IsDark, WindowState = Look.State };
        var station = open();
        var overview = new OverviewViewModel(station, null, null, null, null);
        (window.DataContext, window.Title) = (overview, overview.CellName);
        desktop.MainWindow = window;
        desktop.Exit += (_, _) =>
        {
            overview.Dispose();
            station.Dispose();
        };
    }
}
