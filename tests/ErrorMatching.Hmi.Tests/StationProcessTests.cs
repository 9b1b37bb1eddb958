using System.Diagnostics;
using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The built station as a process: its command line, and its window on an X server.</summary>
public sealed partial class StationProcessTests
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);

    [Theory]
    [InlineData("", 1, "Name the cell's configuration, or --demo.")]
    [InlineData("cell.json --demo", 1, "Name the cell's configuration, or --demo.")]
    [InlineData("--demoo", 1, "--demoo is not an option; --help lists them.")]
    [InlineData("--demo --scale 99", 1, "--scale is out of range; expected 100 to 200.")]
    [InlineData("--demo --scale 201", 1, "--scale is out of range; expected 100 to 200.")]
    [InlineData("nowhere.json", 1, "nowhere.json cannot be opened: ")]
    [InlineData("/dev/null", 1, "/dev/null, line 1, column 1, $: ")]
    [InlineData(
        "--demo", 3, "No X server answers: DISPLAY is not set, or names one that is not there. The operator station needs a screen.")]
    public async Task What_it_cannot_do_is_said_in_a_line_and_by_its_exit_code(string arguments, int exit, string said)
    {
        Drawing.Needed();
        using var folder = new TemporaryFolder();
        using var station = Start(folder.Path, "", arguments);
        var error = await station.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        await station.WaitForExitAsync(TestContext.Current.CancellationToken);
        Assert.Contains(said, error, StringComparison.Ordinal);
        Assert.DoesNotContain("   at ", error, StringComparison.Ordinal);
        Assert.Equal(exit, station.ExitCode);
        Assert.Empty(Directory.EnumerateFileSystemEntries(folder.Path));
    }

    // The screen has 640 by 480 pixels, the window as many as it has units at 100 %: 1280 by 800.
    [Theory]
    [InlineData("--demo", 1280, 800)]
    [InlineData("--demo --scale 150", 1920, 1200)]
    [InlineData("--demo --full-screen", 640, 480)]
    [InlineData("--demo --andon", 640, 480)]
    public async Task Its_window_has_the_size_that_was_asked_for_and_ends_in_order(string arguments, int width, int height)
    {
        Drawing.Needed();
        var display = XServer.Needed("xdotool");
        using var folder = new TemporaryFolder();
        using var station = Start(folder.Path, display, arguments);
        try
        {
            Assert.Equal($"{width}x{height}", await SizeAsync(display));
            Assert.Single(Directory.EnumerateDirectories(folder.Path));

            // As whoever runs it as a service stops it; the demonstration takes its folder away.
            using var end = Process.Start("kill", ["-TERM", $"{station.Id}"]);
            await station.WaitForExitAsync(TestContext.Current.CancellationToken);
            Assert.Equal(0, station.ExitCode);
            Assert.Empty(Directory.EnumerateFileSystemEntries(folder.Path));
        }
        finally
        {
            station.Kill();
        }
    }

    [Fact]
    public async Task A_killed_station_leaves_no_shared_memory()
    {
        Drawing.Needed();
        var display = XServer.Needed("xdotool");
        using var folder = new TemporaryFolder();
        using var station = Start(folder.Path, display, "--demo");
        Assert.NotEqual("", await SizeAsync(display));
        var isShared = SpinWait.SpinUntil(() => SharedMemory.Of(station.Id).Any(s => s.Attached == 2), Patience);
        station.Kill();
        await station.WaitForExitAsync(TestContext.Current.CancellationToken);
        Assert.True(isShared, "The station never shared its frames.");

        // The server detaches when it sees that the station is gone.
        Assert.True(SpinWait.SpinUntil(() => SharedMemory.Of(station.Id).Count == 0, Patience), "A segment remains.");
    }

    [Theory]
    [InlineData("cell.json", 1)]
    [InlineData("keys", 3)]
    public async Task An_account_that_may_not_read_what_a_station_needs_is_told_so_in_a_window(string closed, int exit)
    {
        Drawing.Needed();
        var display = XServer.Needed("xdotool");
        using var folder = new TemporaryFolder();
        var sample = File.ReadAllText(Repository.PathTo("samples", "cell", "cell.json"));
        var job = Repository.PathTo("samples", "complex-mating", "job.json");
        folder.File("cell.json", sample.Replace("../complex-mating/job.json", job, StringComparison.Ordinal)
            .Replace("run/keys", "keys", StringComparison.Ordinal));
        Directory.CreateDirectory(folder["keys"]);
        Process.Start("chmod", ["-R", "a+rX", folder.Path])!.WaitForExit();
        Process.Start("chmod", ["000", folder[closed]])!.WaitForExit();

        // To root nothing is closed.
        string[] other = Environment.IsPrivilegedProcess ? ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "env"] : ["env"];
        using var station = Start(folder.Path, display, [.. other, "HOME=" + folder.Path], "cell.json");
        try
        {
            using var see = Process.Start(
                new ProcessStartInfo("timeout", [$"{Patience.TotalSeconds}", "xdotool", "search", "--sync", "--name", "^ErrorMatching$"])
                {
                    RedirectStandardOutput = true,
                    UseShellExecute = false,
                    Environment = { ["DISPLAY"] = display },
                })!;
            await see.WaitForExitAsync(TestContext.Current.CancellationToken);
            Assert.Equal(0, see.ExitCode);

            // A key that comes before the window takes keys is lost.
            for (var tries = 0; tries < 100 && !station.WaitForExit(TimeSpan.FromSeconds(1)); tries++)
            {
                using var type = Process.Start(
                    new ProcessStartInfo("xdotool", ["search", "--name", "^ErrorMatching$", "key", "Return"])
                    {
                        UseShellExecute = false,
                        RedirectStandardError = true,
                        Environment = { ["DISPLAY"] = display },
                    })!;
                await type.WaitForExitAsync(TestContext.Current.CancellationToken);
            }

            Assert.True(station.HasExited);
            var error = await station.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
            Assert.Matches($"^The account [^ ]+ may not read [^ ]*{closed}\\. A station decides with the cell's keys", error);
            Assert.Equal(exit, station.ExitCode);
        }
        finally
        {
            station.Kill();
        }
    }

    // Pixels of the window, as another program sees it.
    private static async Task<string> SizeAsync(string display)
    {
        using var look = Process.Start(
            new ProcessStartInfo(
                "timeout", [$"{Patience.TotalSeconds}", "xdotool", "search", "--sync", "--name", "Sample cell", "getwindowgeometry"])
            {
                RedirectStandardOutput = true,
                UseShellExecute = false,
                Environment = { ["DISPLAY"] = display },
            })!;
        return Geometry().Match(await look.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken)).Groups["size"].Value;
    }

    private static Process Start(string folder, string display, string arguments) =>
        Start(folder, display, ["env"], arguments.Split(' ', StringSplitOptions.RemoveEmptyEntries));

    // By another program that starts it, such as env.
    private static Process Start(string folder, string display, string[] by, params string[] arguments)
    {
        // Tests and station are built side by side: .../bin/<project>/<configuration>/
        var configuration = new DirectoryInfo(AppContext.BaseDirectory.TrimEnd(Path.DirectorySeparatorChar));
        var executable = Path.Combine(
            configuration.Parent!.Parent!.FullName, "ErrorMatching.Hmi.Desktop", configuration.Name, "errormatch-station");
        return Process.Start(new ProcessStartInfo(by[0], [.. by[1..], executable, .. arguments])
        {
            WorkingDirectory = folder,
            RedirectStandardError = true,
            RedirectStandardOutput = true,
            UseShellExecute = false,
            Environment = { ["DISPLAY"] = display, ["TMPDIR"] = folder },
        })!;
    }

    [GeneratedRegex(@"Geometry: (?<size>\d+x\d+)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Geometry();
}
