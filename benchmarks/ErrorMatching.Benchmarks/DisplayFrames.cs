using System.Diagnostics;
using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.ApplicationLifetimes;
using Avalonia.Media;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Benchmarks;

/// <summary>What it takes to pass whole frames to an X server (Xvfb), with shared memory and through the socket: processor time of a
/// process with one window that changes its background, and of the server.</summary>
internal static class DisplayFrames
{
    private const int Warm = 20, Frames = 200;
    private static readonly PixelSize[] Sizes = [new(1920, 1080), new(3840, 2160)];

    /// <summary>Runs the figures, each in processes of its own.</summary>
    public static async Task<int> RunAsync()
    {
        Console.WriteLine("Whole frames to an X server: ms per frame");
        Console.WriteLine("| size | way | from frame to frame | processor time of the program | of the server |");
        Console.WriteLine("|---|---|---|---|---|");
        foreach (var size in Sizes)
        {
            foreach (var isShared in (bool[])[false, true, false, true])
            {
                await MeasureAsync(size, isShared);
            }
        }

        return 0;
    }

    /// <summary>Shows the frames in a window that fills the screen, and prints the figures of this process.</summary>
    public static int Show()
    {
        var builder = AppBuilder.Configure<Application>();
        builder = OperatingSystem.IsWindows() ? builder.UseWin32() : builder.UseX11();
        builder.SetupWithLifetime(new ClassicDesktopStyleApplicationLifetime());
        var window = new Window { WindowState = WindowState.FullScreen };
        var lifetime = (ClassicDesktopStyleApplicationLifetime)builder.Instance!.ApplicationLifetime!;
        lifetime.MainWindow = window;
        var (count, before, watch) = (0, TimeSpan.Zero, new Stopwatch());
        window.Opened += (_, _) => window.RequestAnimationFrame(Next);
        return lifetime.Start([]);

        void Next(TimeSpan time)
        {
            if (count == Warm)
            {
                (before, watch) = (Environment.CpuUsage.TotalTime, Stopwatch.StartNew());

                // The other process notes the server's time.
                Console.WriteLine("begin");
            }
            else if (count == Warm + Frames)
            {
                Console.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{watch.Elapsed.TotalMilliseconds / Frames:0.0} "
                        + $"{(Environment.CpuUsage.TotalTime - before).TotalMilliseconds / Frames:0.0}"));
                window.Close();
                return;
            }

            count++;
            window.Background = count % 2 == 0 ? Brushes.White : Brushes.Snow;
            window.RequestAnimationFrame(Next);
        }
    }

    private static async Task MeasureAsync(PixelSize size, bool isShared)
    {
        string[] extensions = isShared ? [] : ["-extension", "MIT-SHM"];
        using var server = Start(
            "Xvfb", ["-terminate", "-displayfd", "1", "-screen", "0", $"{size.Width}x{size.Height}x24", "-nolisten", "tcp", .. extensions]);
        var display = ":" + await server.StandardOutput.ReadLineAsync();
        using var window = Start(Environment.ProcessPath!, ["display-window"], display);
        while (await window.StandardOutput.ReadLineAsync() is not ("begin" or null))
        {
        }

        server.Refresh();
        var before = server.TotalProcessorTime;
        var figures = (await window.StandardOutput.ReadLineAsync())?.Split(' ')
            ?? throw new InvalidOperationException("The window's process ended early.");
        server.Refresh();
        var after = server.TotalProcessorTime;
        await window.WaitForExitAsync();
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"| {size.Width}x{size.Height} | {(isShared ? "shared memory" : "socket")} | {figures[0]} | {figures[1]} "
                + $"| {(after - before).TotalMilliseconds / Frames:0.0} |"));
    }

    private static Process Start(string program, IEnumerable<string> arguments, string? display = null)
    {
        var start = new ProcessStartInfo(program, arguments) { RedirectStandardOutput = true, UseShellExecute = false };
        if (display is not null)
        {
            start.Environment["DISPLAY"] = display;
        }

        return Process.Start(start)!;
    }
}
