using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Markup.Xaml;

namespace ErrorMatching.Hmi;

/// <summary>The operator station as an application.</summary>
public sealed partial class App : Application
{
    /// <summary>Opens the station, on the screen's thread; null where somebody else makes the windows.</summary>
    public Func<Station>? Open { get; init; }

    /// <summary>How it begins.</summary>
    public StationLook Look { get; init; } = new(Language.English, IsDark: false, IsFullScreen: false);

    /// <summary>Is told how long the screen's thread was busy at one stretch, wherever that was too long; null if nobody wants to know.</summary>
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
            // The window is made while whoever opens the station may still be busy making its cell.
            Texts.Current.Language = Look.Language;
            var window = new MainWindow { WindowState = Look.IsFullScreen ? WindowState.FullScreen : WindowState.Normal };
            var station = Open();
            var shell = new ShellViewModel(station) { IsDark = Look.IsDark };
            window.DataContext = shell;
            desktop.MainWindow = window;
            var end = new CancellationTokenSource();
            if (Busy is not null)
            {
                // What it takes to make the window is no news.
                window.Opened += (_, _) => _ = new ScreenWatch(SynchronizationContext.Current!, TimeProvider.System, Busy).RunAsync(end.Token).Watched();
            }

            window.Opened += (_, _) => _ = window.RehearseAsync(end.Token).Watched();
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
}
