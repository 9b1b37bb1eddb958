using System.CommandLine;
using System.Globalization;
using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Threading;
using ErrorMatching.Cell;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi.Desktop;

/// <summary>The station's command line: the cell to connect to, or the demonstration.</summary>
internal static class StationCommand
{
    /// <summary>The exit code if the command line or the configuration is wrong, as in the console.</summary>
    public const int WrongInput = 1;

    // Something outside failed, such as a store or a screen.
    private const int Outside = 3;
    private const int Least = 100, Most = 200;

    /// <summary>The command.</summary>
    /// <param name="log">Where it says what it has to say outside its window.</param>
    public static RootCommand Make(StationLog log)
    {
        var config = new Argument<string?>("CONFIG") { Description = "The cell's configuration.", Arity = ArgumentArity.ZeroOrOne };

        // Otherwise a misspelled option would be a configuration that cannot be opened.
        config.Validators.Add(result =>
        {
            if (result.Tokens is [{ Value: ['-', _, ..] option }])
            {
                result.AddError($"{option} is not an option; --help lists them.");
            }
        });
        var demo = new Option<bool>("--demo")
        {
            Description = "A cell to play with: the samples in a folder of their own, with a gauge that delivers and a machine that cuts "
                + "by themselves."
        };
        var chinese = new Option<bool>("--chinese") { Description = "Begin in Traditional Chinese." };
        var dark = new Option<bool>("--dark") { Description = "Begin light on dark." };
        var full = new Option<bool>("--full-screen") { Description = "Fill the screen." };
        var andon = new Option<bool>("--andon")
        {
            Description = "Only the overview, as large as the screen, for a wall: readable from five meters, and nobody signs in."
        };
        var scale = new Option<int?>("--scale")
        {
            Description = "Size of everything in percent, 100 to 200. Without it, as large as the monitor's size asks for; on Windows in "
                + "addition to the system's own setting.",
            HelpName = "PERCENT"
        };
        scale.Validators.Add(result =>
        {
            if (result.GetValueOrDefault<int?>() is < Least or > Most)
            {
                result.AddError(string.Create(CultureInfo.InvariantCulture, $"--scale is out of range; expected {Least} to {Most}."));
            }
        });
        var command = new RootCommand("The operator station of ErrorMatching.") { config, demo, chinese, dark, full, andon, scale };
        command.SetAction(result => Run(
            result.GetValue(config),
            result.GetValue(demo),
            new StationLook(
                result.GetValue(chinese) ? Language.TraditionalChinese : Language.English,
                result.GetValue(dark),
                result.GetValue(full),

                // X11 may have no window manager that could maximize.
                IsMaximized: OperatingSystem.IsWindows())
            {
                IsAndon = result.GetValue(andon),
            },
            result.GetValue(scale) / 100.0,
            log));
        return command;
    }

    private static int Run(string? config, bool isDemo, StationLook look, double? scaling, StationLog log)
    {
        if (isDemo == config is not null)
        {
            log.Fail("Name the cell's configuration, or --demo.");
            return WrongInput;
        }

        try
        {
            if (config is not null && StationAccess.Refusal(config) is { } unreadable)
            {
                return Refuse(unreadable, WrongInput, scaling, log);
            }

            // The demonstration creates its cell while the window is prepared: both take a second.
            var demonstration = isDemo ? Task.Run(() => Demonstration.Start(TimeProvider.System)) : null;
            var settings = isDemo ? null : CellSettingsReader.Read(config!);
            if (settings is not null && StationAccess.Refusal(settings) is { } refusal)
            {
                return Refuse(refusal, Outside, scaling, log);
            }

            using var stop = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Leave);
            using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Leave);
            try
            {
                var builder = AppBuilder.Configure(
                    () => new App
                    {
                        Open = () => Open(settings, demonstration?.GetAwaiter().GetResult()),
                        Look = look,
                        Busy = t => TellBusy(t, log),
                    });
                return StationPlatform.Use(builder, scaling, log.Tell).StartWithClassicDesktopLifetime([]);
            }
            finally
            {
                demonstration?.GetAwaiter().GetResult().Dispose();
            }
        }
        catch (InputException e)
        {
            log.Fail(e.Message);
            return WrongInput;
        }
        catch (Exception e) when (
            e is PlatformNotSupportedException or StoreException or PeopleException or IOException or UnauthorizedAccessException)
        {
            log.Fail(e.Message);
            return Outside;
        }
    }

    // A restart does not help, so the sentence stays until somebody has read it: in a window, if nobody sees the error stream.
    private static int Refuse(string sentence, int exit, double? scaling, StationLog log)
    {
        log.Fail(sentence);
        if (!OperatingSystem.IsWindows() && Console.IsErrorRedirected)
        {
            var builder = AppBuilder.Configure(() => new SentenceApp(sentence));
            StationPlatform.Use(builder, scaling, log.Tell).StartWithClassicDesktopLifetime([]);
        }

        return exit;
    }

    private static Station Open(CellSettings? configured, Demonstration? demonstration)
    {
        var settings = configured ?? demonstration!.Settings;
        return new(settings, TimeProvider.System, Station.DefaultIdle)
        {
            Preferences = Preferences(settings, demonstration is not null),
            IsDemonstration = demonstration is not null,
            SamplesFolder = demonstration?.SamplesFolder,
        };
    }

    // A demonstration leaves nothing behind. A service without a home folder stores no preferences.
    private static PreferenceFiles? Preferences(CellSettings settings, bool isDemo)
    {
        var folder = isDemo
            ? Path.GetDirectoryName(Path.GetFullPath(settings.File))
            : Environment.GetFolderPath(Environment.SpecialFolder.ApplicationData, Environment.SpecialFolderOption.DoNotVerify);
        return string.IsNullOrEmpty(folder) ? null : new(Path.Combine(folder, "errormatch"));
    }

    // For the log of the service manager: a user had to wait, and this is when.
    private static void TellBusy(TimeSpan time, StationLog log) =>
        log.Warn(string.Create(CultureInfo.InvariantCulture, $"The screen was busy for {time.TotalMilliseconds:0} ms"));

    // As if the window were closed: the session ends properly, and the demonstration deletes its folder.
    private static void Leave(PosixSignalContext signal)
    {
        signal.Cancel = true;
        Dispatcher.UIThread.Post(() => (Application.Current?.ApplicationLifetime as IClassicDesktopStyleApplicationLifetime)?.Shutdown());
    }
}
