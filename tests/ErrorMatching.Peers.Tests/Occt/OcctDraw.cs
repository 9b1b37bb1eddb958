using System.Diagnostics;
using System.Runtime.InteropServices;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// The CAD kernel OCCT as a program: its Tcl interpreter DRAW, from Debian's package occt-draw.
/// Curves and surfaces, IGES and STEP are judged by it.
/// </summary>
internal static class OcctDraw
{
    private const int LimitMs = 180_000;
    private const string Package = "occt-draw";
    private const string Done = "-- the script came to its end --";

    private static readonly string? Executable = (Environment.GetEnvironmentVariable("PATH") ?? "")
        .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Select(f => Path.Combine(f, "occt-draw"))
        .FirstOrDefault(File.Exists);

    /// <summary>Skips the current test where the peer is not installed, or fails it where ERRORMATCH_PEERS=required demands it.</summary>
    public static void IsNeeded()
    {
        if (Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") == "required")
        {
            Assert.True(Executable is not null, $"occt-draw is missing: install the package {Package}.");
        }

        Assert.SkipUnless(Executable is not null, $"occt-draw is not installed (package {Package}).");
    }

    /// <summary>Runs a Tcl script with the commands of modeling and data exchange, and fails the test if it does not come to its
    /// end.</summary>
    /// <param name="script">The script. What DRAW's commands answer is printed only by <c>puts</c>.</param>
    /// <param name="files">Files that the script finds where it runs: their names and contents.</param>
    /// <returns>What the script printed.</returns>
    public static string Run(string script, params (string Name, string Text)[] files)
    {
        var folder = Directory.CreateTempSubdirectory("errormatch-peer-").FullName;
        try
        {
            foreach (var (name, text) in files)
            {
                File.WriteAllText(Path.Combine(folder, name), text);
            }

            File.WriteAllText(Path.Combine(folder, "script.tcl"), $"pload MODELING XSDRAW\n{script}\nputs {{{Done}}}\n");
            return Run(folder);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static string Run(string folder)
    {
        var start = new ProcessStartInfo(Executable!, ["-b", "-f", "script.tcl"])
        {
            UseShellExecute = false,
            WorkingDirectory = folder,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment["LD_LIBRARY_PATH"] = Plugins(folder);
        using var process = Process.Start(start)!;
        process.StandardInput.Close();
        var token = TestContext.Current.CancellationToken;
        var (output, error) = (process.StandardOutput.ReadToEndAsync(token), process.StandardError.ReadToEndAsync(token));
        if (!process.WaitForExit(LimitMs))
        {
            process.Kill(entireProcessTree: true);
            Assert.Fail($"occt-draw runs longer than {LimitMs} ms.");
        }

        var said = output.GetAwaiter().GetResult();
        Assert.True(
            said.Contains(Done, StringComparison.Ordinal),
            $"occt-draw stopped, exit {process.ExitCode}:\n{said}\n{error.GetAwaiter().GetResult()}");
        return said;
    }

    // DRAW loads its plugins by names without a version, which the package does not install.
    private static string Plugins(string folder)
    {
        var links = Directory.CreateDirectory(Path.Combine(folder, "plugins")).FullName;
        var triplet = RuntimeInformation.OSArchitecture == Architecture.Arm64 ? "aarch64-linux-gnu" : "x86_64-linux-gnu";
        foreach (var library in new[] { "libTKTopTest.so", "libTKXSDRAW.so" })
        {
            var installed = Directory.EnumerateFiles(Path.Combine("/usr/lib", triplet), library + "*")
                .Order(StringComparer.Ordinal)
                .FirstOrDefault();
            Assert.True(installed is not null, $"{library} is missing in /usr/lib/{triplet}.");
            File.CreateSymbolicLink(Path.Combine(links, library), installed);
        }

        return links;
    }
}
