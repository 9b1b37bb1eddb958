using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The report of the complex sample, as a station reads it from the store: 16 points within ±0.05 mm.</summary>
internal static class SampleReport
{
    /// <summary>The report of a job that was changed.</summary>
    public static MatchReport Of(Func<string, string>? change = null)
    {
        using var folder = new TemporaryFolder();
        foreach (var file in Directory.GetFiles(Path.Combine(AppContext.BaseDirectory, "samples", "complex-mating")))
        {
            File.Copy(file, folder[Path.GetFileName(file)]);
        }

        var job = folder["job.json"];
        File.WriteAllText(job, (change ?? (j => j))(File.ReadAllText(job)));
        return StoredReport.Read(MatingRun.Run(new(job), new(), CancellationToken.None).Result!.ReportJson()).Match!;
    }

    /// <summary>The same with other errors left at some points.</summary>
    public static MatchReport Leaving(this MatchReport report, params (string Point, double Mm)[] left) => report with
    {
        KeyPoints = [
            .. report.KeyPoints.Select(
                p => left.Where(l => l.Point == p.Point).Select(l => (double?)l.Mm).FirstOrDefault() is { } mm
                    ? p with { PredictedMm = mm }
                    : p)],
    };

    /// <summary>The same as a version wrote it that knew no intervals.</summary>
    public static MatchReport Older(this MatchReport report) => report with
    {
        ProbabilityAfter = null,
        Features = [.. report.Features.Select(f => f with { WorstBetween = null })],
        KeyPoints = [.. report.KeyPoints.Select(p => p with { Interval95Mm = null })],
    };
}
