using System.Diagnostics;
using System.Globalization;
using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>The processor time of <c>surface compensate</c> on Surface one with 61 x 51 measured points and some 144,000 motions, on
/// Linux.</summary>
internal static class DenseCompensation
{
    private const int Runs = 11, Curves = 61, Each = 51;

    /// <summary>Runs the figures.</summary>
    public static int Run()
    {
        var console = Measurement.Errormatch;
        var folder = Directory.CreateTempSubdirectory("errormatch-").FullName;
        try
        {
            var (job, measured) = (Path.Combine(folder, "job.json"), Path.Combine(folder, "measured.csv"));
            File.Copy(Repository.PathTo("samples", "surface-one", "surface.igs"), Path.Combine(folder, "surface.igs"));
            File.WriteAllText(job, Job());
            File.WriteAllText(measured, Measured(job));
            var (times, processor) = (new List<double>(), new List<double>());
            for (var run = 0; run < Runs; run++)
            {
                var (watch, before) = (Stopwatch.StartNew(), Measurement.ProcessorTimeOfChildren());
                using var process = Process.Start(
                    new ProcessStartInfo(
                        console, ["surface", "compensate", job, "--measured", measured, "--out", Path.Combine(folder, "out")])
                    {
                        UseShellExecute = false,
                        RedirectStandardOutput = true,
                    })!;
                process.StandardOutput.ReadToEnd();
                process.WaitForExit();
                if (process.ExitCode != 0)
                {
                    throw new InvalidOperationException($"surface compensate ended with {process.ExitCode}.");
                }

                times.Add(watch.Elapsed.TotalSeconds);
                processor.Add(Measurement.ProcessorTimeOfChildren() - before);
            }

            times.Sort();
            processor.Sort();
            var motions = File.ReadLines(Path.Combine(folder, "out", FinishedSurface.Name))
                .Count(l => l.Length > 0 && l[0] is 'G' or 'X' or 'Y' or 'Z');
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"surface compensate, {Curves} x {Each} points, {motions} motions: processor time median {processor[Runs / 2]:0.00} s, "
                    + $"least {processor[0]:0.00} s; median {times[Runs / 2]:0.00} s, least {times[0]:0.00} s, of {Runs} runs"));
            return 0;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static string Job()
    {
        var job = JsonNode.Parse(File.ReadAllText(Repository.PathTo("samples", "surface-one", "job.json")))!;
        (job["measuring"]!["curves"], job["measuring"]!["pointsPerCurve"]) = (Curves, Each);
        var path = job["toolpath"]!;
        (path["dialect"], path["scallopMm"], path["chordMm"]) = ("linuxcnc", 0.000108, 0.0006);
        return job.ToJsonString();
    }

    // Waves longer than the surface, a slope, and noise of 0.5 um on the stock of semi-finishing.
    private static string Measured(string job)
    {
        var files = new FreeformFiles(job);
        var plan = files.Plan(files.Surface());
        var random = new Random(27);
        var text = new StringBuilder("point,x,y,z\n");
        foreach (var point in plan.Points)
        {
            var (x, y) = (point.Position.X / 75, point.Position.Y / 63);
            var noise = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
            var error = (0.010 * Math.Sin((3 * x) + 1) * Math.Cos(2 * y)) + (0.006 * x * y) - (0.004 * y * y) + (0.0005 * noise);
            var at = point.Position + (point.Normal * (plan.StockMm + error));
            text.Append(CultureInfo.InvariantCulture, $"{point.Number},{at.X:F4},{at.Y:F4},{at.Z:F4}\n");
        }

        return text.ToString();
    }
}
