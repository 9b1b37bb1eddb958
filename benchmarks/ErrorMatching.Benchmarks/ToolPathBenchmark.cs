using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Benchmarks;

/// <summary>The paper's Surface three with a scallop height and a chordal error of 1 um, and the same surface ten times as large, whose
/// path has more than a million points: planned, and written to disk.</summary>
internal static class ToolPathBenchmark
{
    private const int Runs = 5;

    /// <summary>Runs the figures.</summary>
    public static int Run()
    {
        Console.WriteLine(
            "| path | passes | points | planned s | planned, cpu s | written, cpu s | points/s of a core, both | MB | memory while it is "
                + "written, MB |");
        Console.WriteLine("|---|---|---|---|---|---|---|---|---|");
        Show("Surface three, 75 x 63 mm", 1, plans: Runs);
        Show("Surface three, 750 x 630 mm", 10, plans: 3);
        return 0;
    }

    private static void Show(string name, double scale, int plans)
    {
        var dialect = NcDialects.LinuxCnc;
        var job = Job();
        var surface = SurfaceThree(scale);
        var (planned, planning, written) = (double.MaxValue, double.MaxValue, double.MaxValue);
        var (bytes, memory) = (0L, 0L);
        ToolPath? path = null;
        var file = Path.GetTempFileName();
        try
        {
            for (var run = 0; run < Runs; run++)
            {
                if (run < plans)
                {
                    var watch = Stopwatch.StartNew();
                    var before = Process.GetCurrentProcess().TotalProcessorTime;
                    path = ToolPathPlanner.Plan(surface, job.Tool, job.Toolpath, 0, dialect).Path!;
                    planned = Math.Min(planned, watch.Elapsed.TotalSeconds);
                    planning = Math.Min(planning, (Process.GetCurrentProcess().TotalProcessorTime - before).TotalSeconds);
                }

                GC.Collect();
                var held = GC.GetTotalMemory(forceFullCollection: true);
                var allocated = GC.GetAllocatedBytesForCurrentThread();
                using var stream = File.Create(file);
                var start = Process.GetCurrentProcess().TotalProcessorTime;
                FinishingProgram.Write(path!, job, dialect, CuttingStage.Finishing, stream);
                stream.Flush();
                written = Math.Min(written, (Process.GetCurrentProcess().TotalProcessorTime - start).TotalSeconds);
                memory = Math.Max(GC.GetTotalMemory(forceFullCollection: false) - held, GC.GetAllocatedBytesForCurrentThread() - allocated);
                bytes = stream.Length;
            }
        }
        finally
        {
            File.Delete(file);
        }

        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"| {name} | {path!.Passes} | {path.Points} | {planned:0.000} | {planning:0.000} | {written:0.000} | "
                + $"{path.Points / (planning + written) / 1e6:0.00} million | {bytes / 1e6:0.0} | {memory / 1e6:0.00} |"));
    }

    private static FreeformJob Job() => FreeformJob.Parse(
        """
        { "kind": "freeform", "name": "Surface three", "surface": "surface.igs", "tool": { "kind": "ball", "diameterMm": 6 }, "spindleRpm": 10000, "feedMmPerMin": 1200,
          "measuring": { "curves": 7, "pointsPerCurve": 10, "stylusDiameterMm": 6, "dialect": "linuxcnc" },
          "toolpath": { "dialect": "linuxcnc", "passes": "zigzag", "scallopMm": 0.001, "chordMm": 0.001 } }
        """u8,
        "job.json");

    // z = 24 + 0.004 ((y - 31.5)^2 (2x/75 - 1) + (x - 37.5)^2 (2y/63 - 1)) over 75 x 63 mm, exactly.
    private static PartSurface SurfaceThree(double scale)
    {
        var poles = new Point3[9];
        for (var i = 0; i < 9; i++)
        {
            var (x, y) = (i / 3, i % 3);
            poles[i] = new(scale * 37.5 * x, scale * 31.5 * y, scale * Pole(x, k => Pole(y, l => Height(37.5 * k, 31.5 * l))));
        }

        return new("three", new(KnotVector.Clamped(2, [0, 1]), KnotVector.Clamped(2, [0, 1]), poles), SurfaceRegion.Whole, 1);
    }

    private static double Height(double x, double y) =>
        24 + (0.004 * (((y - 31.5) * (y - 31.5) * ((2 * x / 75) - 1)) + ((x - 37.5) * (x - 37.5) * ((2 * y / 63) - 1))));

    // The pole of a quadratic Bezier polynomial from its values at 0, 1/2 and 1.
    private static double Pole(int number, Func<int, double> value) =>
        number == 1 ? (2 * value(1)) - ((value(0) + value(2)) / 2) : value(number);
}
