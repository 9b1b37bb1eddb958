using System.Globalization;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Parts from another program, whose whole boundary is known (<c>KnownParts</c>): smooth errors, a gauge with 2 um of noise. Each has shown
/// an estimate that went wrong: a course that swings beside its points, a curve of five points, an end that slid along a shallow lead-out
/// past an outer key point; two curves that were each alone where they meet, which left 100 um, where moved block ends leave 28. The
/// limits are what a joint least-squares fit of the same program reaches; of the two curves, about half of what moved block ends leave.
/// </summary>
public sealed class KnownPartTests
{
    [Theory]
    [InlineData("swing", 0.0039, 0.012)]
    [InlineData("five-points", 0.0087, 0.02)]
    [InlineData("shallow-lead-out", 0.0048, 0.012)]
    [InlineData("two-curves", 0.004, 0.016)]
    public void The_counterpart_follows_a_part_that_is_known_throughout(string name, double rms, double largest)
    {
        var folder = Path.Combine(Repository.Root, "tests", "ErrorMatching.EndToEnd.Tests", "KnownParts", name);
        var job = MatingJob.Parse(File.ReadAllBytes(Path.Combine(folder, "job.json")), "job.json");
        var result = Assert.IsType<MatchResult>(Matcher.Match(new(
            job,
            Measured("theoretical.csv"),
            Measured("part.csv"),
            null,
            "counterpart.nc",
            File.ReadAllBytes(Path.Combine(folder, "counterpart.nc")))).Result);
        var path = SmoothMatch.PathOf(result.Program);
        double[] left = [
            .. File.ReadLines(Path.Combine(folder, "truth.csv")).Skip(1)
                .Select(line => line.Split(',').Select(v => double.Parse(v, CultureInfo.InvariantCulture)).ToArray())
                .Select(v => SmoothMatch.DistanceTo(path, new(v[^2], v[^1])) - (job.Counterpart.ToolDiameterMm / 2))];

        Assert.InRange(SmoothMatch.Rms(left), 0, rms);
        Assert.InRange(left.Max(Math.Abs), 0, largest);

        // The interval of the worst place holds it, wherever it is.
        Assert.InRange(left.Max(Math.Abs), 0, result.Prediction.Features.Max(f => f.WorstBetween!.BoundMm));

        // Nor is an error expected that is not there: past a corner of the part, and in the hollow corner of two blocks.
        Assert.All(result.Prediction.Features, f => Assert.InRange(Math.Abs(f.WorstBetween!.AfterMm), 0, largest));

        MeasurementFile Measured(string file) =>
            MeasurementReader.Read(File.ReadAllBytes(Path.Combine(folder, file)), file, job.Gauge.Format);
    }
}
