using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Layout;
using Avalonia.Media;
using Avalonia.Themes.Fluent;

namespace ErrorMatching.Hmi.Desktop;

/// <summary>A window with a sentence instead of the station, for what prevents the station and no restart mends. A user who starts it from
/// a menu sees no error stream.</summary>
internal sealed class SentenceApp(string sentence) : Application
{
    private const double LeastWidth = 640, LeastHeight = 260, Space = 24;

    /// <inheritdoc/>
    public override void Initialize() => Styles.Add(new FluentTheme());

    /// <inheritdoc/>
    public override void OnFrameworkInitializationCompleted()
    {
        if (ApplicationLifetime is IClassicDesktopStyleApplicationLifetime desktop)
        {
            var close = new Button { Content = "Close", IsDefault = true, IsCancel = true };
            DockPanel.SetDock(close, Dock.Bottom);
            close.HorizontalAlignment = HorizontalAlignment.Right;
            close.Click += (_, _) => desktop.Shutdown();
            desktop.MainWindow = new Window
            {
                Title = "ErrorMatching",
                Width = LeastWidth,
                Height = LeastHeight,
                Content = new DockPanel
                {
                    Margin = new(Space),
                    Children = { close, new TextBlock { Text = sentence, TextWrapping = TextWrapping.Wrap } },
                },
            };
        }

        base.OnFrameworkInitializationCompleted();
    }
}
