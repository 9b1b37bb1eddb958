using System.Diagnostics;
using ErrorMatching.EndToEnd.Tests;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>The console for Windows, published once from what is built, and Wine with a prefix of its own, from Debian's package
/// wine64.</summary>
/// <remarks>Wine is not Windows. It runs the same program on another implementation of the same calls: paths, locks, replacing, culture and
/// native libraries show themselves. It says nothing about services, the Event Log, DPAPI or fonts.</remarks>
public sealed class WineConsole : IAsyncLifetime
{
    private const string Wine = "/usr/lib/wine/wine64", Server = "/usr/lib/wine/wineserver64", Package = "wine64";

    private const string Locales = "/usr/share/i18n/locales";

    private static readonly bool IsThere = File.Exists(Wine);

    private readonly TemporaryFolder _folder = new();
    private Process? _keeper;

    /// <summary>Skips the current test where Wine is not installed, or fails it where ERRORMATCH_PEERS=required demands it.</summary>
    public static void IsNeeded() => Demand(IsThere, "Wine", Package);

    /// <summary>Publishes the console while Wine makes its prefix.</summary>
    public async ValueTask InitializeAsync()
    {
        if (IsThere)
        {
            var prefix = Succeeded(Windows("wineboot", "-i"));
            await Succeeded(Publishing());
            await prefix;

            // As long as one program runs, Wine's own services go on; without it, each run would start them again, which takes 2 s. They
            // inherit the streams of the program that started them, so that must be this one: to wait for the end of such a stream is to
            // wait for the services.
            var keeping = Windows("cmd", "/c", "echo begun & more");
            keeping.RedirectStandardInput = keeping.RedirectStandardOutput = keeping.RedirectStandardError = true;
            _keeper = Process.Start(keeping)!;
            var line = await _keeper.StandardOutput.ReadLineAsync(TestContext.Current.CancellationToken);
            Assert.StartsWith("begun", line, StringComparison.Ordinal);
        }
    }

    /// <summary>How the console for Windows is started.</summary>
    public ProcessStartInfo Start(params string[] arguments) => Windows([Path.Combine(_folder["console"], "errormatch.exe"), .. arguments]);

    /// <summary>How a program for Windows is started.</summary>
    public ProcessStartInfo Windows(params string[] command)
    {
        var start = new ProcessStartInfo(Wine, command) { WorkingDirectory = Repository.Root };
        start.Environment["WINEPREFIX"] = _folder["prefix"];
        start.Environment["WINEDEBUG"] = "-all";

        // Without a window it asks nothing, such as whether to install Gecko; what crashes just ends.
        start.Environment["WINEDLLOVERRIDES"] = "mshtml=;winedbg.exe=d";
        start.Environment["DISPLAY"] = "";

        // With it, the runtime ends with an internal error in dynamic methods: Wine's doing, not ours.
        start.Environment["DOTNET_EnableWriteXorExecute"] = "0";
        return start;
    }

    /// <summary>The same with the language of a country, which Wine takes from this system's.</summary>
    public ProcessStartInfo In(string locale, ProcessStartInfo start)
    {
        start.Environment["LOCPATH"] = _folder["locales"];
        start.Environment["LC_ALL"] = locale + ".UTF-8";
        return start;
    }

    /// <summary>Makes the language of a country, of the sources in Debian's package locales.</summary>
    public async Task MakeLocale(string locale)
    {
        Demand(File.Exists(Path.Combine(Locales, locale)), $"The language {locale}", "locales");
        Directory.CreateDirectory(_folder["locales"]);
        await Succeeded(new("localedef", ["-i", locale, "-f", "UTF-8", Path.Combine(_folder["locales"], locale + ".UTF-8")]));
    }

    /// <summary>Ends the processes of the prefix and deletes everything.</summary>
    public async ValueTask DisposeAsync()
    {
        if (IsThere)
        {
            var end = new ProcessStartInfo(Server, ["-k", "-w"]);
            end.Environment["WINEPREFIX"] = _folder["prefix"];
            using var process = Process.Start(end)!;
            await process.WaitForExitAsync(CancellationToken.None);
            _keeper?.Dispose();
        }

        _folder.Dispose();
    }

    private static void Demand(bool isThere, string what, string package)
    {
        if (Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") == "required")
        {
            Assert.True(isThere, $"{what} is missing: install the package {package}.");
        }

        Assert.SkipUnless(isThere, $"{what} is not installed (package {package}).");
    }

    private static async Task Succeeded(ProcessStartInfo start)
    {
        var run = await ConsoleRun.Of(start);
        Assert.True(run.Exit == 0, $"{start.FileName} {string.Join(' ', start.ArgumentList)}: exit {run.Exit}. {run.Output}{run.Error}");
    }

    private ProcessStartInfo Publishing()
    {
        var configuration = Path.GetFileName(AppContext.BaseDirectory.TrimEnd(Path.DirectorySeparatorChar));
        var start = new ProcessStartInfo("dotnet", [
            "publish",
            Repository.PathTo("src", "ErrorMatching.Console"),
            "-c", configuration == "release" ? "Release" : "Debug",
            "-r", "win-x64",
            "--self-contained",
            "-o", _folder["console"],
            "-v", "q",
            "-nologo",
            "-nodeReuse:false",
            "-p:UseSharedCompilation=false",
            $"-p:CustomBeforeDirectoryBuildProps={Repository.PathTo("tests", "ErrorMatching.Peers.Tests", "Wine", "windows.props")}"])
        {
            WorkingDirectory = Repository.Root,
        };

        // Otherwise lock files would be demanded, and these are none of the repository's.
        start.Environment["CI"] = "";
        return start;
    }
}
