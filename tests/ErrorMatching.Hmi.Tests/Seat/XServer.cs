using System.Diagnostics;

namespace ErrorMatching.Hmi.Tests;

/// <summary>An X server without a screen, of its own for the tests of this process.</summary>
internal static class XServer
{
    /// <summary>Starts one, which ends with the last program that is connected to it: Xlib ends a program whose server goes first. Skips
    /// the current test where Xvfb or another program that it needs is not installed,
    /// or fails it where ERRORMATCH_PEERS=required demands them.</summary>
    /// <param name="others">What the test needs beside the server.</param>
    /// <returns>The name of its display.</returns>
    public static string Needed(params IEnumerable<string> others)
    {
        foreach (var program in others.Prepend("Xvfb"))
        {
            var isThere = (
                Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Any(p => File.Exists(Path.Combine(p, program)));
            Assert.True(isThere || Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") != "required", $"{program} is not installed.");
            Assert.SkipUnless(isThere, $"{program} is not installed.");
        }

        // It names the first display that is free, once it answers there.
        using var process = Process.Start(
            new ProcessStartInfo("Xvfb", ["-terminate", "-displayfd", "1", "-screen", "0", "640x480x24", "-nolisten", "tcp"])
            {
                RedirectStandardOutput = true,
                UseShellExecute = false
            })!;
        return ":" + process.StandardOutput.ReadLine();
    }
}
