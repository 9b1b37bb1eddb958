using System.Diagnostics;
using System.Text.RegularExpressions;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// LinuxCNC's own interpreter as a program, from Debian's package linuxcnc-uspace. Each run has a home of its own:
/// instances share a file in it and stop each other otherwise.
/// </summary>
internal static partial class Rs274
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
    /// <param name="program">The text.</param>
    /// <param name="tools">The table.</param>
    /// <param name="folder">A folder with subprograms that it can call; null for none.</param>
    public static PeerRun RunWithTools(string program, string tools, string? folder = null) => WithHome(home =>
    {
        var (file, table) = (Path.Combine(home, "program.ngc"), Path.Combine(home, "tool.tbl"));
        File.WriteAllText(file, program);
        File.WriteAllText(table, tools);
        return Run(file, home, folder ?? home, options: ["-t", table]);
    });

    /// <summary>Interprets a text as if it stood in a folder, whose subprograms it can call.</summary>
    public static PeerRun Run(string program, string folder) => WithHome(home =>
    {
        var file = Path.Combine(home, "program.ngc");
        File.WriteAllBytes(file, System.Text.Encoding.Latin1.GetBytes(program));
        return Run(file, home, folder);
    });

    /// <summary>Runs blocks one after the other in one process, which goes on after each error, and returns what it says of each.</summary>
    /// <param name="reset">Blocks before each of them, so that none depends on the one before.</param>
    /// <param name="blocks">The blocks, each with those that it needs.</param>
    /// <returns>The messages; null where a block is accepted.</returns>
    public static IReadOnlyList<string?> RunBlocks(IReadOnlyList<string> reset,
        IReadOnlyList<(IReadOnlyList<string> Before, string Block)> blocks)
    {
        var home = Directory.CreateTempSubdirectory("errormatch-peer-").FullName;
        try
        {
            var lines = blocks.SelectMany((b, i) => (IEnumerable<string>)[.. reset, .. b.Before, $"(MSG,<{i})", b.Block, $"(MSG,>{i})"]);
            File.WriteAllText(Path.Combine(home, "program.ngc"), string.Join('\n', [.. lines, "M2", ""]));
            File.WriteAllText(Path.Combine(home, "tool.tbl"), string.Concat(Enumerable.Range(1, 20).Select(n => $"T{n} P{n} Z0 D0.2\n")));

            // Messages and errors are in order only where both go to one pipe.
            var start = new ProcessStartInfo("/bin/sh", ["-c", $"exec '{Executable}' -n 0 -t tool.tbl -g program.ngc 2>&1"])
            {
                UseShellExecute = false,
                WorkingDirectory = home,
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
            };
            start.Environment["HOME"] = home;
            using var process = Process.Start(start)!;
            process.StandardInput.Close();
            var output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return Said(output, blocks.Count);
        }
        finally
        {
            Directory.Delete(home, recursive: true);
        }
    }

    // What is not a canonical command between the marks of a block is an error, its text first.
    private static string?[] Said(string output, int count)
    {
        var said = new string?[count];
        var (block, before) = (-1, 0);
        foreach (var line in output.Split('\n'))
        {
            if (Mark().Match(line) is { Success: true } mark)
            {
                var number = int.Parse(mark.Groups["number"].ValueSpan, System.Globalization.CultureInfo.InvariantCulture);
                block = mark.Groups["side"].Value == "<" ? number : -1;
                before = number + 1;
            }
            else if (!Command().IsMatch(line))
            {
                Assert.True(block >= 0, $"rs274 refuses what is before block {before}: {line}");
                said[block] ??= line;
            }
        }

        Assert.Equal(count, before);
        return said;
    }

    [GeneratedRegex(@"MESSAGE\(""(?<side>[<>])(?<number>[0-9]+)""\)", RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Mark();

    [GeneratedRegex(@"^\s*[0-9]+ N\S*\s+[A-Z0-9_]+ *\(|^executing$|^\s*$", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Command();

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
