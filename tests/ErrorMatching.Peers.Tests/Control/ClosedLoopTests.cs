using System.Globalization;
using System.Text;
using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;
using ErrorMatching.Jobs;

namespace ErrorMatching.Peers.Tests;

/// <summary>The whole loop on a real control: it probes a virtual slot, the cell fetches the log and matches it, the control cuts the key,
/// and the path that its servo loop commanded is judged.</summary>
public sealed class ClosedLoopTests(LinuxCncControl control) : IClassFixture<LinuxCncControl>
{
    private const string Log = "PART.CSV";
    private const string Program = "KEY.NGC";
    private const double Ball = 3;
    private const double ToolRadius = 3;
    private const double Depth = -8;

    // What the servo path may add to the prediction, beside the control's own path tolerance.
    private const double Allowed = 0.002;

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public async Task The_counterpart_is_cut_as_the_match_of_a_probed_part_predicted()
    {
        LinuxCncControl.IsNeeded();
        await using var cell = await StartAsync();

        // Probe the part. Its log appears at once when all points are touched.
        await File.WriteAllTextAsync(Path.Combine(control.Nc, "PROBE.NGC"), ProbingProgram(cell.PathOf("job/job.json")), Token);
        await control.OpenAsync("PROBE.NGC");
        await control.RunAsync();
        await control.UntilStatusAsync("IDLE");
        Assert.Equal(5, (await control.PlaceAsync()).Z, 6);

        // The cell fetches it, matches, and loads the program.
        var verified = await cell.Until(1, CorrectionState.Verified);
        Assert.Equal((Log, "part"), (verified.FileName, verified.Piece));

        // Run it.
        await control.OpenAsync(Program);
        await control.RunAsync();
        await control.UntilStatusAsync("IDLE");
        Assert.Equal(50, (await control.PlaceAsync()).Z, 6);
        var path = await control.LastCutAsync(Depth);
        using var report = JsonDocument.Parse(cell.Store.Content(verified.ReportSha256!));
        var points = report.RootElement.GetProperty("keyPoints").EnumerateArray().Select(p => Judge(p, path)).ToArray();
        Assert.Equal(8, points.Length);
        var output = TestContext.Current.TestOutputHelper!;
        output.WriteLine($"{path.Count} servo samples in the cut");
        foreach (var (point, before, predicted, cut, probed) in points)
        {
            output.WriteLine(
                $"| {point} | {Micro(before)} | {Micro(predicted)} | {Micro(cut)} | {Micro(cut - predicted)} | {Micro(probed)} |");
        }

        Assert.All(points, p => Assert.InRange(p.Cut - p.Predicted, -Allowed - SlotJob.PathTolerance, Allowed + SlotJob.PathTolerance));

        // Within the job's limits, and without the loop it would not be. What remains is the taper, which no slot with parallel flanks has.
        Assert.Contains(points, p => Math.Abs(p.Before) > 0.02);
        Assert.All(points, p => Assert.InRange(p.Cut, -0.02, 0.02));
    }

    private static string Micro(double mm) => (Math.Round(1000 * mm, 1) + 0.0).ToString("+0.0;-0.0;0.0", CultureInfo.InvariantCulture);

    // Mating error of the cut: the tool's center is one radius from what it leaves.
    private static (string Point, double Before, double Predicted, double Cut, double Probed) Judge(
        JsonElement point, List<(double X, double Y)> path)
    {
        var (x, y) = (point.GetProperty("actual").GetProperty("x").GetDouble(), point.GetProperty("actual").GetProperty("y").GetDouble());
        return (
            point.GetProperty("point").GetString()!,
            point.GetProperty("uncompensatedMm").GetDouble(),
            point.GetProperty("predictedMm").GetDouble(),
            Distance(x, y, path) - ToolRadius,
            VirtualSlot.Room(x, y));
    }

    private static double Distance(double x, double y, List<(double X, double Y)> path) => path.Zip(path.Skip(1)).Min(s =>
    {
        var (dx, dy) = (s.Second.X - s.First.X, s.Second.Y - s.First.Y);
        var length = (dx * dx) + (dy * dy);
        var t = length == 0 ? 0 : Math.Clamp((((x - s.First.X) * dx) + ((y - s.First.Y) * dy)) / length, 0, 1);
        return Math.Sqrt(Math.Pow(x - s.First.X - (t * dx), 2) + Math.Pow(y - s.First.Y - (t * dy), 2));
    });

    private string ProbingProgram(string job)
    {
        var template = TwiceTemplate.Write(Path.GetDirectoryName(job)!, Path.Combine(control.Nc, Log));
        var probed = ProbedJob.Make(
            job,
            new()
            {
                TouchZ = -5,
                ClearanceZ = 5,
                ApproachMm = 1,
                OvertravelMm = 0.8,
                ToolNumber = 2,
                Template = template,
            },
            Token);
        Assert.True(probed.IsUsable, probed.Refusal?.ToString());
        Assert.Empty(probed.Result!.Program.Moves.Assumed);
        return Encoding.ASCII.GetString(probed.Result.Program.Bytes.Span);
    }

    private async Task<ConfiguredCell> StartAsync()
    {
        var cell = new ConfiguredCell($$"""
            "gauges": [{
              "name": "probe", "machine": "mill", "files": "{{Log}}", "format": "points", "finished": { "atRestS": 0.3 }, "everyMs": 100 }],
            "machines": [{
              "name": "mill", "dialect": "linuxcnc", "transport": { "kind": "folder", "folder": "{{control.Nc}}" },
              "state": { "kind": "linuxcnc", "host": "127.0.0.1", "port": {{control.Port}} },
              "slots": [{ "name": "A", "program": "{{Program}}" }] }],
            "jobs": [{
              "name": "slot", "job": "job/job.json", "gauges": ["probe"], "machine": "mill", "slot": "A",
              "recognize": { "fileName": "^PART[.]CSV$" } }],
            "policy": { "approve": "automatic" }
            """);
        await SlotJob.LayOutAsync(cell.PathOf("job"));
        cell.Change(
            "job/job.json",
            "\"format\": \"points\"",
            FormattableString.Invariant($"\"format\": \"points\", \"reports\": \"stylus-center\", \"stylusDiameterMm\": {Ball}"));
        cell.Start();
        return cell;
    }
}
