using System.Diagnostics;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// LinuxCNC's own interpreter as a program, from Debian's package linuxcnc-uspace. Each run has a home of its own:
/// instances share a file in it and stop each other otherwise.
/// </summary>
internal static class Rs274
{
    private const int LimitMs = 180_000;
    private const string Package = "linuxcnc-uspace";

    private static readonly string? Executable = (Environment.GetEnvironmentVariable("PATH") ?? "")
        .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Select(f => Path.Combine(f, "rs274"))
        .FirstOrDefault(File.Exists);

    /// <summary>Skips the current test where the peer is not installed, or fails it where ERRORMATCH_PEERS=required demands it.</summary>
    public static void IsNeeded()
    {
        if (Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") == "required")
        {
            Assert.True(Executable is not null, $"rs274 is missing: install the package {Package}.");
        }

        Assert.SkipUnless(Executable is not null, $"rs274 is not installed (package {Package}).");
    }

    /// <summary>Interprets a program's text.</summary>
    /// <param name="program">The text.</param>
    /// <param name="skips">True if blocks behind a slash are passed over.</param>
    public static PeerRun Run(string program, bool skips = false) => WithHome(home =>
    {
        var file = Path.Combine(home, "program.ngc");
        File.WriteAllText(file, program);
        return Run(file, home, home, skips);
    });

    /// <summary>Interprets a text with a table of tools, in inches, since without settings the machine is one of inches.</summary>
    public static PeerRun RunWithTools(string program, string tools) => WithHome(home =>
    {
        var (file, table) = (Path.Combine(home, "program.ngc"), Path.Combine(home, "tool.tbl"));
        File.WriteAllText(file, program);
        File.WriteAllText(table, tools);
        return Run(file, home, home, options: ["-t", table]);
    });

    /// <summary>Interprets a text as if it stood in a folder, whose subprograms it can call.</summary>
    public static PeerRun Run(string program, string folder) => WithHome(home =>
    {
        var file = Path.Combine(home, "program.ngc");
        File.WriteAllBytes(file, System.Text.Encoding.Latin1.GetBytes(program));
        return Run(file, home, folder);
    });

    // The last origin and rotation that the control was given.
    private static PeerOrigin Origin(string[] lines)
    {
        double[] Last(string name) =>
            lines.LastOrDefault(l => l.Contains($" {name}(", StringComparison.Ordinal)) is { } line
                ? [
                    .. line[(line.IndexOf('(', StringComparison.Ordinal) + 1)..line.LastIndexOf(')')].Split(',').Select(
                        t => double.Parse(t, System.Globalization.CultureInfo.InvariantCulture))]
                : [0, 0, 0];
        var (origin, turn) = (Last("SET_G5X_OFFSET"), Last("SET_XY_ROTATION"));
        return new(origin[1], origin[2], turn[0]);
    }

    private static PeerRun WithHome(Func<string, PeerRun> run)
    {
        var home = Directory.CreateTempSubdirectory("errormatch-peer-").FullName;
        try
        {
            return run(home);
        }
        finally
        {
            Directory.Delete(home, recursive: true);
        }
    }

    private static PeerRun Run(string file, string home, string folder, bool skips = false, params string[] options)
    {
        var start = new ProcessStartInfo(Executable!, [.. options, .. skips ? (string[])["-b"] : [], "-g", file])
        {
            UseShellExecute = false,
            WorkingDirectory = folder,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment["HOME"] = home;
        using var process = Process.Start(start)!;
        process.StandardInput.Close();
        var token = TestContext.Current.CancellationToken;
        var (output, error) = (process.StandardOutput.ReadToEndAsync(token), process.StandardError.ReadToEndAsync(token));
        if (!process.WaitForExit(LimitMs))
        {
            process.Kill(entireProcessTree: true);
            return new([], $"It runs longer than {LimitMs} ms.");
        }

        var lines = output.GetAwaiter().GetResult().Split('\n');
        var said = error.GetAwaiter().GetResult().Replace("executing\n", "", StringComparison.Ordinal).Trim();
        return new(new CanonReader().Read(lines), process.ExitCode == 0 ? null : $"exit {process.ExitCode}: {said}")
        {
            Origin = Origin(lines),
            Log = [
                .. lines.Select(
                    l => l.IndexOf(" LOG(\"", StringComparison.Ordinal) is >= 0 and var at ? l[(at + 6)..l.LastIndexOf('"')] : null)
                    .OfType<string>()],
        };
    }
}
