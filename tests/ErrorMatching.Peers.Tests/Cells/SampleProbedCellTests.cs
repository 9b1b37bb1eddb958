using System.Diagnostics;
using ErrorMatching.Cell.Tests;
using ErrorMatching.EndToEnd.Tests;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>The sample of a cell that fetches a probing log, as its README runs it.</summary>
public sealed class SampleProbedCellTests
{
    [Fact]
    public async Task Its_log_has_the_points_and_the_plan_of_the_measured_sample()
    {
        var (file, log) = (Repository.PathTo("samples", "probed-cell", "probe.log"), await ProbedPiece.LogAsync());
        if (Environment.GetEnvironmentVariable("UPDATE_SAMPLES") == "1")
        {
            await File.WriteAllTextAsync(file, log, TestContext.Current.CancellationToken);
        }

        Assert.Equal(log, (await File.ReadAllTextAsync(file, TestContext.Current.CancellationToken)).ReplaceLineEndings("\n"));
    }

    [Fact]
    public async Task A_log_at_the_control_becomes_the_finishing_program_there()
    {
        using var folder = new TemporaryFolder();
        foreach (var file in new[] { "probed-cell/cell.json", "probed-cell/probe.log", "surface-one/job.json", "surface-one/surface.igs" })
        {
            Directory.CreateDirectory(Path.GetDirectoryName(folder["samples/" + file])!);
            File.Copy(Repository.PathTo("samples", file), folder["samples/" + file]);
        }

        var control = Directory.CreateDirectory(folder["samples/probed-cell/control"]).FullName;
        var made = await ConsoleRun.Of(
            folder.Path,
            "surface",
            "compensate",
            "samples/surface-one/job.json",
            "--measured",
            "samples/probed-cell/probe.log",
            "--out",
            "out");
        Assert.True(made.Exit == 0, made.Output + made.Error);
        var start = new ProcessStartInfo(ConsoleRun.Executable, ["cell", "run", "samples/probed-cell/cell.json"])
        {
            UseShellExecute = false,
            WorkingDirectory = folder.Path,
            RedirectStandardOutput = true,
            RedirectStandardError = true
        };
        using var cell = Process.Start(start)!;
        try
        {
            cell.BeginOutputReadLine();
            cell.BeginErrorReadLine();
            File.Copy(folder["samples/probed-cell/probe.log"], Path.Combine(control, "PROBE.LOG"));
            await ConfiguredCell.Until(
                () => File.Exists(Path.Combine(control, "FINISH.MPF")) && !File.Exists(Path.Combine(control, "PROBE.LOG")));
            Assert.Equal(File.ReadAllBytes(folder["out/finishing.nc"]), File.ReadAllBytes(Path.Combine(control, "FINISH.MPF")));
        }
        finally
        {
            cell.Kill(entireProcessTree: true);
            await cell.WaitForExitAsync(CancellationToken.None);
        }
    }
}
