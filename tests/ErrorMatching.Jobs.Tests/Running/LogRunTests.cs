using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>The part of the sample as controls print it, read by its job.</summary>
public sealed class LogRunTests
{
    private static readonly string[] Files = ["job.json", "theoretical.csv", "part.csv", "counterpart.nc", "counterpart.csv"];

    private static readonly (string Label, string X, string Y)[] Table = [
        .. File.ReadLines(Repository.PathTo("samples", "complex-mating", "part.csv"))
            .Skip(1).Select(l => l.Split(',')).Select(c => (c[0], c[1], c[2]))];

    // The tip of the tooth, point 3, is in the sample's files and is no key point of its job.
    private static readonly (string Label, string X, string Y)[] Needed = [.. Table.Where(p => p.Label != "3")];

    [Fact]
    public void A_log_without_labels_has_the_order_of_the_theoretical_file()
    {
        using var folder = Copied();
        var log = new GivenFile("log.txt", Bytes(Table.Select(p => $"{p.X} {p.Y} 0.0 0.0 0.0 0.0 0.0 0.0 0.0")));
        AreSame(new JobFiles(folder["job.json"]), log);
    }

    [Fact]
    public void A_log_without_labels_may_have_only_the_points_that_the_job_needs()
    {
        using var folder = Copied();
        var theoretical = File.ReadAllLines(folder["theoretical.csv"]);
        File.WriteAllLines(folder["theoretical.csv"], [theoretical[0], "spare,0,0", .. theoretical[1..]]);
        var log = Needed.Select(p => $"[PRB:{p.X},{p.Y},0.000:1]").ToArray();
        AreSame(new JobFiles(folder["job.json"]), new GivenFile("log.txt", Bytes(log)));
        var all = new JobFiles(folder["job.json"]).Part(
            new GivenFile("log.txt", Bytes(["[PRB:9.000,9.000,0.000:1]", .. Table.Select(p => $"[PRB:{p.X},{p.Y},0.000:1]")])));
        Assert.Equal(9, all["spare"].Position.X);
        var error = Assert.Throws<InputException>(
            () => new JobFiles(folder["job.json"]).Part(new GivenFile("log.txt", Bytes(log[1..]))));
        Assert.Equal((MeasurementError.PointCount, "log.txt"), (error.Code, error.File));
        var count = string.Create(CultureInfo.InvariantCulture, $"{Needed.Length - 1} points");
        Assert.Contains(count, error.Message, StringComparison.Ordinal);
        Assert.Contains(string.Create(CultureInfo.InvariantCulture, $"{Needed.Length}, one"), error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_given_theoretical_file_is_the_order_of_the_log()
    {
        using var folder = Copied();
        var lines = File.ReadAllLines(folder["theoretical.csv"]);
        File.WriteAllLines(folder["given.csv"], [lines[0], .. lines[1..].Reverse()]);
        var log = new GivenFile("log.txt", Bytes(Table.Reverse().Select(p => $"[PRB:{p.X},{p.Y},0.000:1]")));
        var files = new JobFiles(folder["job.json"]);
        AreSame(files, log, files.Theoretical(new(folder["given.csv"])));
    }

    [Fact]
    public void A_list_in_the_job_is_the_order_of_the_log()
    {
        using var folder = Copied();
        var labels = string.Join(", ", Table.Reverse().Select(p => $"\"{p.Label}\""));
        Gauge(folder, $"\"labels\": [{labels}], ");
        AreSame(
            new JobFiles(folder["job.json"]),
            new GivenFile("log.txt", Bytes(Table.Reverse().Select(p => $"[PRB:{p.X},{p.Y},0.000:1]"))));
    }

    [Fact]
    public void A_rule_in_the_job_maps_the_labels()
    {
        using var folder = Copied();
        var log = new GivenFile("log.csv", Bytes(["point,x_mm,y_mm", .. Table.Select(p => $"PNT{p.Label},{p.X},{p.Y}")]));
        var error = Assert.Throws<InputException>(() => new JobFiles(folder["job.json"]).Part(log)["1"]);
        Assert.Contains("\"labels\": \"PNT{n}\"", error.Message, StringComparison.Ordinal);
        Gauge(folder, "\"labels\": \"PNT{label}\", ");
        AreSame(new JobFiles(folder["job.json"]), log);
        Assert.Equal("PNT{label}", new JobFiles(folder["job.json"]).Job.Gauge.Labels!.ToString());
    }

    [Theory]
    [InlineData("\"PNT\"", "$.gauge.labels")]
    [InlineData("[\"14..5\"]", "$.gauge.labels[0]")]
    [InlineData("[\"1\", \"1..3\"]", "$.gauge.labels")]
    public void A_rule_that_cannot_be_used_is_named_by_its_place(string labels, string path)
    {
        using var folder = Copied();
        Gauge(folder, $"\"labels\": {labels}, ");
        Assert.Equal(path, Assert.Throws<InputException>(() => new JobFiles(folder["job.json"])).Place.Path);
    }

    [Fact]
    public void A_log_without_labels_is_no_theoretical_file()
    {
        using var folder = Copied();
        File.WriteAllText(folder["theoretical.csv"], "[PRB:1.0,2.0,3.0:1]\n");
        Assert.Equal(
            MeasurementError.MissingColumn,
            Assert.Throws<InputException>(() => new JobFiles(folder["job.json"]).Theoretical()).Code);
    }

    private static void AreSame(JobFiles files, GivenFile log, MeasurementFile? theoretical = null)
    {
        var part = files.Part(log, theoretical);
        foreach (var (label, x, y) in Needed)
        {
            Assert.Equal(double.Parse(x, CultureInfo.InvariantCulture), part[label].Position.X);
            Assert.Equal(double.Parse(y, CultureInfo.InvariantCulture), part[label].Position.Y);
        }
    }

    private static void Gauge(TemporaryFolder folder, string keys) => File.WriteAllText(
        folder["job.json"],
        File.ReadAllText(folder["job.json"]).Replace("\"gauge\": { ", "\"gauge\": { " + keys, StringComparison.Ordinal));

    private static byte[] Bytes(IEnumerable<string> lines) => System.Text.Encoding.UTF8.GetBytes(string.Join('\n', lines) + "\n");

    private static TemporaryFolder Copied()
    {
        var folder = new TemporaryFolder();
        foreach (var file in Files)
        {
            File.Copy(Repository.PathTo("samples", "complex-mating", file), folder[file]);
        }

        return folder;
    }
}
