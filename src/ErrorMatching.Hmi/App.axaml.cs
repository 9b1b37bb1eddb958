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

    /// <inheritdoc/>
    public override void Initialize() => AvaloniaXamlLoader.Load(this);

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
            desktop.Exit += (_, _) =>
            {
                shell.Dispose();
                station.Dispose();
            };
        }

        base.OnFrameworkInitializationCompleted();
    }
}
