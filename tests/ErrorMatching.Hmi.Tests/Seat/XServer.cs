using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Tests;

/// <summary>An X server without a screen, of its own for the tests of this process.</summary>
internal static class XServer
{
    private static string? _connected;
    private static TouchScreen? _touched;

    /// <summary>Skips the current test where Xvfb or another program that it needs is not installed,
    /// or fails it where ERRORMATCH_PEERS=required demands them.</summary>
    /// <param name="others">What the test needs beside the server.</param>
    public static void Present(params IEnumerable<string> others)
    {
        foreach (var program in others.Prepend("Xvfb"))
        {
            var isThere = (
                Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Any(p => File.Exists(Path.Combine(p, program)));
            Demand(program, isThere);
        }
    }

    /// <summary>Skips the current test, or fails it, where there is no server with a touch screen.</summary>
    public static void TouchPresent() => Demand("Xorg with its drivers dummy and inputtest", TouchScreen.IsInstalled);

    /// <summary>Starts one, which ends with the last program that is connected to it: Xlib ends a program whose server goes first. Skips
    /// as <see cref="Present"/>.</summary>
    /// <returns>The name of its display.</returns>
    public static string Needed(params IEnumerable<string> others)
    {
        Present(others);

        // It names the first display that is free, once it answers there.
        using var process = Process.Start(
            new ProcessStartInfo("Xvfb", ["-terminate", "-displayfd", "1", "-screen", "0", "640x480x24", "-nolisten", "tcp"])
            {
                RedirectStandardOutput = true,
                UseShellExecute = false
            })!;
        return ":" + process.StandardOutput.ReadLine();
    }

    /// <summary>The touch screen of the server that the platform is connected to.</summary>
    public static TouchScreen Touched => _touched ?? throw new InvalidOperationException("The server has no touch screen.");

    /// <summary>Connects the station's platform to a server, once, on the UI thread: the connection lasts as long as the process. The
    /// server has a touch screen where one can be had.</summary>
    /// <returns>The name of the display.</returns>
    public static string Connect()
    {
        if (_connected is null)
        {
            _touched = TouchScreen.IsInstalled ? TouchScreen.Start() : null;
            X11Connection.Open(_connected = _touched?.Display ?? Needed());
        }

        return _connected;
    }

    /// <summary>Has another program, xdotool, do something on the server that the platform is connected to, such as move the
    /// mouse.</summary>
    /// <returns>What it says.</returns>
    public static string Do(params IEnumerable<string> arguments)
    {
        using var process = Process.Start(
            new ProcessStartInfo("xdotool", arguments)
            {
                RedirectStandardOutput = true,
                UseShellExecute = false,
                Environment = { ["DISPLAY"] = _connected }
            })!;
        var answer = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.Equal(0, process.ExitCode);
        return answer;
    }

    /// <summary>A property of a window with a title, as the numbers of 32 bits that it has.</summary>
    public static unsafe long[] Property(string title, string name)
    {
        var window = nint.Parse(Do("search", "--name", title), CultureInfo.InvariantCulture);
        var display = X11Connection.Display;
        _ = Xlib.XGetWindowProperty(
            display, window, Xlib.XInternAtom(display, name, 0), 0, 100, 0, 0, out _, out var format, out var items, out _, out var data);
        Assert.Equal(32, format);
        var values = new ReadOnlySpan<long>(data, (int)items).ToArray();
        _ = Xlib.XFree(data);
        return values;
    }

    private static void Demand(string program, bool isThere)
    {
        Assert.True(isThere || Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") != "required", $"{program} is not installed.");
        Assert.SkipUnless(isThere, $"{program} is not installed.");
    }
}
