using System.Diagnostics;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The table of <c>tests/corpora</c>, for a folder with one program of each row.</summary>
[Trait("Runs", "Console")]
public sealed class CorporaTests
{
    [Fact]
    public void Each_row_counts_its_programs()
    {
        using var folder = new TemporaryFolder();
        folder.File("known.nc", "G90 G17 G40 G0 X0. Y0. Z0.\nG1 X1. F100.\n");
        folder.File("same.nc", "G90 G17 G40 G0 X0. Y0. Z0.\nG1 X1. F100.\n");
        folder.File("said.nc", "G90 G0 Z5.\nG0 X0. Y0.\n");
        folder.File("partly.nc", "G90 G17 G40 G0 X0. Y0. Z0.\nG999\nX1.\n");
        folder.File("macro.ngc", "o1 sub\ng0 x1\no1 endsub\n");
        folder.File("called.nc", "G90 G0 X0. Y0. Z0.\nM98 P1\n");
        folder.File("skipped.nc", "G90 G0 X0. Y0. Z0.\n/G91\nG1 X1. F100.\n");
        folder.File("text.txt", "No program.\n");
        File.CreateSymbolicLink(folder["link.nc"], folder["partly.nc"]);
        var (exit, table) = Run(folder.Path);
        string[] rows =
        [
            "programs 6", "all known 1 17 %", "once said 1 17 %", "partly 1 17 %", "no motion 1 17 %", "refused 2 33 %", "block-skip 1",
            "missing-program 1", "crashed 0 0 %",
        ];
        Assert.Equal((0, string.Join('\n', rows)), (exit, string.Join('\n', table.Take(rows.Length))));
        Assert.StartsWith("time ", table[rows.Length], StringComparison.Ordinal);
    }

    [Fact]
    public void A_console_that_ends_otherwise_counts_as_crashed()
    {
        using var folder = new TemporaryFolder();
        folder.File("p.nc", "G0 X1.\n");
        var (exit, table) = Run(folder.Path, "--console", "/bin/false");
        Assert.Equal(1, exit);
        Assert.Contains("crashed 1 100 %", table);
        Assert.Contains("exit 1 1", table);
    }

    private static (int Exit, string[] Table) Run(string folder, params string[] more)
    {
        var start = new ProcessStartInfo(Repository.PathTo("tests", "corpora")) { UseShellExecute = false, RedirectStandardOutput = true };
        foreach (var argument in (string[])[folder, "--console", ConsoleRun.Executable, .. more])
        {
            start.ArgumentList.Add(argument);
        }

        using var process = Process.Start(start)!;
        var text = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, [.. text.Split('\n').Select(l => string.Join(' ', l.Split(' ', StringSplitOptions.RemoveEmptyEntries)))]);
    }
}
