using System.Diagnostics;

namespace ErrorMatching.Hmi.Tests;

/// <summary>An X server without a screen, of its own for the tests of this process.</summary>
internal static class XServer
{
    /// <summary>Starts one, which ends with the last program that is connected to it: Xlib ends a program whose server goes first. Skips the current test where Xvfb is not installed, or fails it where ERRORMATCH_PEERS=required demands it.</summary>
    /// <returns>The name of its display.</returns>
    public static string Needed()
    {
        var isThere = (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Any(p => File.Exists(Path.Combine(p, "Xvfb")));
        Assert.True(isThere || Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") != "required", "Xvfb is not installed.");
        Assert.SkipUnless(isThere, "Xvfb is not installed.");

        // It names the first display that is free, once it answers there.
        using var process = Process.Start(new ProcessStartInfo("Xvfb", ["-terminate", "-displayfd", "1", "-screen", "0", "640x480x24", "-nolisten", "tcp"]) { RedirectStandardOutput = true, UseShellExecute = false })!;
        return ":" + process.StandardOutput.ReadLine();
    }
}
