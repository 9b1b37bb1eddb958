using System.Diagnostics;
using System.Globalization;
using System.Text;
using ErrorMatching.Freeform;

namespace ErrorMatching.Benchmarks;

/// <summary>The fit <c>best</c> as a user sees it: the first call of a process, the later ones, and the console from start to
/// exit.</summary>
internal static class SurfaceFitTimes
{
    private const int Runs = 5;

    /// <summary>Runs the figures.</summary>
    /// <param name="points">70 or 5000; null for both.</param>
    public static int Run(string? points)
    {
        var console = Measurement.Errormatch;
        var folder = Directory.CreateTempSubdirectory("errormatch-").FullName;
        try
        {
            Console.WriteLine(
                "| points | shape | noise um | first call in a process ms | later calls ms | whole process `surface fit` ms |");
            Console.WriteLine("|---|---|---|---|---|---|");
            foreach (var count in points is null ? new[] { 70, 5000 } : [int.Parse(points, CultureInfo.InvariantCulture)])
            {
                foreach (var name in FitShape.Names)
                {
                    foreach (var noise in new[] { 0, 1 })
                    {
                        Show(name, count, noise, console, Path.Combine(folder, "points.csv"));
                    }
                }
            }

            return 0;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    /// <summary>Times of one process in milliseconds: its first call, and the median of the later ones.</summary>
    public static int Once(string name, string points, string noise)
    {
        var grid = FitShape.Grid(name, int.Parse(points, CultureInfo.InvariantCulture), double.Parse(noise, CultureInfo.InvariantCulture));
        var first = Time(grid);
        var later = Enumerable.Range(0, grid.Points.Count() > 1000 ? 2 : 60).Select(_ => Time(grid)).TakeLast(15).Order().ToArray();
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{first} {later[later.Length / 2]}"));
        return 0;
    }

    private static double Time(PointGrid grid)
    {
        var watch = Stopwatch.StartNew();
        _ = SurfaceFitter.Fit(grid, FitMethod.Best, JobFit.Default.CurveToleranceMm);
        return watch.Elapsed.TotalMilliseconds;
    }

    private static void Show(string name, int points, int noise, string console, string file)
    {
        File.WriteAllText(file, Csv(FitShape.Grid(name, points, noise)));
        var runs = points > 1000 ? 1 : Runs;
        var inside = Enumerable.Range(0, runs).Select(_ => Output(
            Environment.ProcessPath!,
            "fit-once",
            name,
            points.ToString(CultureInfo.InvariantCulture),
            noise.ToString(CultureInfo.InvariantCulture)))
            .Select(line => line.Split(' ').Select(x => double.Parse(x, CultureInfo.InvariantCulture)).ToArray()).ToArray();
        var whole = Enumerable.Range(0, runs).Select(_ =>
        {
            var watch = Stopwatch.StartNew();
            Output(console, "surface", "fit", file);
            return watch.Elapsed.TotalMilliseconds;
        });
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"| {points} | {name} | {noise} | {Median(inside.Select(t => t[0])):0} | {Median(inside.Select(t => t[1])):0} | "
                + $"{Median(whole):0} |"));
    }

    private static string Output(string file, params string[] arguments)
    {
        using var process = Process.Start(
            new ProcessStartInfo(file, arguments) { UseShellExecute = false, RedirectStandardOutput = true })!;
        var output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return process.ExitCode == 0 ? output : throw new InvalidOperationException($"{file} ended with {process.ExitCode}.");
    }

    private static string Csv(PointGrid grid)
    {
        var text = new StringBuilder("i,j,x,y,z\n");
        foreach (var p in grid.Points)
        {
            text.Append(CultureInfo.InvariantCulture, $"{p.I},{p.J},{p.Position.X:R},{p.Position.Y:R},{p.Position.Z:R}\n");
        }

        return text.ToString();
    }

    private static double Median(IEnumerable<double> values)
    {
        var sorted = values.Order().ToArray();
        return sorted[sorted.Length / 2];
    }
}
