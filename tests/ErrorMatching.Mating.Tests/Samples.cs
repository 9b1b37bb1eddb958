using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>The samples, whose measured coordinates are the paper's tables.</summary>
internal static class Samples
{
    public static MatingJob Job(string sample) => MatingJob.Read(Repository.PathTo("samples", sample, "job.json"));

    /// <summary>A sample's job with more comparisons.</summary>
    public static MatingJob Job(string sample, params JobComparison[] comparisons) => Job(sample) with { Verify = comparisons };

    public static IReadOnlyDictionary<string, Point2> Points(string sample, string file) =>
        MeasurementReader.Read(
            Repository.PathTo("samples", sample, file),
            MeasurementFormat.Points).Points.ToDictionary(p => p.Label, p => new Point2(p.Position.X, p.Position.Y));

    /// <summary>The sample's part and both counterparts, with one normal everywhere: the paper takes its deviations in x.</summary>
    public static IReadOnlyList<IReadOnlyList<VerifiedPoint>> Verified(string sample, MatingJob job)
    {
        var (part, before, after) = (
            Points(sample, "part.csv"), Points(sample, "counterpart.csv"), Points(sample, "counterpart-after.csv"));
        return [
            .. job.Features.Select(f => f.Points.Select(l => new VerifiedPoint(l, part[l], before[l], after[l], new(-1, 0))).ToArray())];
    }

    /// <summary>Rows of one of the paper's tables, by column name.</summary>
    public static IReadOnlyList<IReadOnlyDictionary<string, string>> Table(string name)
    {
        var lines = File.ReadAllLines(Repository.PathTo("tests", "ErrorMatching.EndToEnd.Tests", "Data", "wang2021", name));
        var header = lines[0].Split(',');
        return [.. lines.Skip(1).Select(l => header.Zip(l.Split(',')).ToDictionary(c => c.First, c => c.Second))];
    }

    public static double Number(this IReadOnlyDictionary<string, string> row, string column) =>
        double.Parse(row[column], System.Globalization.CultureInfo.InvariantCulture);
}
