using System.Globalization;
using System.Text;
using ErrorMatching.EndToEnd.Tests;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>The sample surface as a job with a short tool path, the log that its probing program writes,
/// and the finishing program that the console makes of it.</summary>
internal static class ProbedPiece
{
    private static readonly Lazy<Task<string>> PlanOnce = new(PlanAsync);
    private static readonly Lazy<Task<byte[]>> ProgramOnce = new(async () => await FinishAsync(await LogAsync()));

    /// <summary>Lays the job out in a folder.</summary>
    public static void LayOut(string folder)
    {
        Directory.CreateDirectory(folder);
        File.Copy(Repository.PathTo("samples", "surface-one", "surface.igs"), Path.Combine(folder, "surface.igs"));
        var job = File.ReadAllText(Repository.PathTo("samples", "surface-one", "job.json"));
        Assert.Contains("\"scallopMm\": 0.001, \"chordMm\": 0.001", job, StringComparison.Ordinal);
        File.WriteAllText(
            Path.Combine(folder, "job.json"),
            job.Replace("\"scallopMm\": 0.001, \"chordMm\": 0.001", "\"scallopMm\": 0.05, \"chordMm\": 0.01", StringComparison.Ordinal));
    }

    /// <summary>The number of the plan, as the console says it.</summary>
    public static Task<string> Plan => PlanOnce.Value;

    /// <summary>The finishing program of <see cref="LogAsync"/>.</summary>
    public static Task<byte[]> Program => ProgramOnce.Value;

    /// <summary>The log of the measured sample.</summary>
    /// <param name="plan">The plan's number; null for the job's.</param>
    /// <param name="zMm">How much higher each point was touched.</param>
    public static async Task<string> LogAsync(string? plan = null, double zMm = 0)
    {
        var log = new StringBuilder($"ERRORMATCH PROBE PLAN {plan ?? await Plan} MM\n");
        foreach (var row in File.ReadLines(Repository.PathTo("samples", "surface-one", "measured.csv")).Skip(1).Select(l => l.Split(',')))
        {
            log.Append(
                CultureInfo.InvariantCulture,
                $"P{row[0]} S X{row[1]} Y{row[2]} Z{double.Parse(row[3], CultureInfo.InvariantCulture) + zMm:0.0000}\n");
        }

        return log.Append("END\n").ToString();
    }

    /// <summary>The finishing program that the console writes for a log.</summary>
    public static async Task<byte[]> FinishAsync(string log)
    {
        using var folder = new TemporaryFolder();
        LayOut(folder["job"]);
        File.WriteAllText(folder["log"], log);
        var run = await ConsoleRun.Of(folder.Path, "surface", "compensate", "job/job.json", "--measured", "log", "--out", "out");
        Assert.True(run.Exit == 0, run.Output + run.Error);
        return File.ReadAllBytes(folder["out/finishing.nc"]);
    }

    private static async Task<string> PlanAsync()
    {
        using var folder = new TemporaryFolder();
        LayOut(folder["job"]);
        var run = await ConsoleRun.Of(folder.Path, "surface", "probe", "job/job.json", "--out", "out", "--json");
        Assert.True(run.Exit == 0, run.Output + run.Error);
        return run.Json.GetProperty("plan").GetString()!;
    }
}
