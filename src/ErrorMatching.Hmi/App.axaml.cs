using Avalonia;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Markup.Xaml;

namespace ErrorMatching.Hmi;

/// <summary>The operator station as an application.</summary>
public sealed partial class App : Application
{
    /// <summary>Opens the station, on the screen's thread; null where somebody else makes the windows.</summary>
    public Func<Station>? Open { get; init; }

    /// <inheritdoc/>
    public override void Initialize() => AvaloniaXamlLoader.Load(this);

    /// <inheritdoc/>
    public override void OnFrameworkInitializationCompleted()
    {
        if (ApplicationLifetime is IClassicDesktopStyleApplicationLifetime desktop && Open is not null)
        {
            var station = Open();
            var shell = new ShellViewModel(station);
            desktop.MainWindow = new MainWindow { DataContext = shell };
            desktop.Exit += (_, _) =>
            {
                shell.Dispose();
                station.Dispose();
            };
        }

        base.OnFrameworkInitializationCompleted();
    }
}
