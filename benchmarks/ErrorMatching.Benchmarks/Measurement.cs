using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>The shortest duration of an operation, and its peak memory.</summary>
internal sealed record Measurement(string Name, double Seconds, long PeakBytes)
{
    /// <summary>The console that is timed: what <c>ERRORMATCH_CONSOLE</c> names, such as the native one of <c>deploy/pack --native</c>;
    /// without it, the one from the build.</summary>
    public static string Errormatch => Environment.GetEnvironmentVariable("ERRORMATCH_CONSOLE")
        ?? Repository.PathTo(
            "artifacts", "bin", "ErrorMatching.Console", "release", OperatingSystem.IsWindows() ? "errormatch.exe" : "errormatch");

    /// <summary>Runs a process several times, from its start to its exit.</summary>
    public static Measurement OfProcess(int runs, string name, string executable, string[] arguments, string home)
    {
        var best = new Measurement(name, double.MaxValue, 0);
        for (var run = 0; run < runs; run++)
        {
            var start = new ProcessStartInfo(executable, arguments)
            {
                UseShellExecute = false,
                RedirectStandardOutput = true,
                RedirectStandardError = true
            };
            start.Environment["HOME"] = home;
            var watch = Stopwatch.StartNew();
            using var process = Process.Start(start)!;
            var (output, error) = (process.StandardOutput.BaseStream.CopyToAsync(Stream.Null), process.StandardError.ReadToEndAsync());
            var peak = 0L;
            while (!process.WaitForExit(5))
            {
                peak = Math.Max(peak, PeakOf(process.Id));
            }

            Task.WaitAll(output, error);
            var seconds = watch.Elapsed.TotalSeconds;
            if (process.ExitCode != 0)
            {
                throw new InvalidOperationException($"{name} ended with {process.ExitCode}: {error.Result}");
            }

            best = best with { Seconds = Math.Min(best.Seconds, seconds), PeakBytes = Math.Max(best.PeakBytes, peak) };
        }

        return best;
    }

    /// <summary>Seconds of user and system time of the processes that have ended, in ticks of 10 ms (proc(5): cutime and cstime).</summary>
    public static double ProcessorTimeOfChildren()
    {
        var fields = File.ReadAllText("/proc/self/stat").Split(')')[^1].Split(' ', StringSplitOptions.RemoveEmptyEntries);
        return (long.Parse(fields[13], CultureInfo.InvariantCulture) + long.Parse(fields[14], CultureInfo.InvariantCulture)) / 100.0;
    }

    // The kernel's own high-water mark, read until the process is gone.
    private static long PeakOf(int id)
    {
        var status = $"/proc/{id}/status";
        try
        {
            var line = File.Exists(status)
                ? File.ReadLines(status).FirstOrDefault(l => l.StartsWith("VmHWM:", StringComparison.Ordinal))
                : null;
            return line is null
                ? 0
                : 1024 * long.Parse(line.Split(' ', StringSplitOptions.RemoveEmptyEntries)[1], CultureInfo.InvariantCulture);
        }
        catch (IOException)
        {
            // It exited between the two calls; the earlier readings stand.
            return 0;
        }
    }
}
