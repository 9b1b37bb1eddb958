using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>Times the built console as a user runs it, from the start of the process to its exit.</summary>
internal static class WholeProcess
{
    private const int Runs = 21;

    /// <summary>Runs the figures.</summary>
    public static int Run()
    {
        var console = Measurement.Errormatch;
        var folder = Directory.CreateTempSubdirectory("errormatch-").FullName;
        try
        {
            Report("errormatch --version", console, ["--version"]);
            foreach (var mating in new[] { "complex-mating", "curve-mating", "circle-mating", "slot-mating", "dovetail" })
            {
                Report(
                    $"errormatch match {mating} --out",
                    console,
                    ["match", Repository.PathTo("samples", mating, "job.json"), "--out", Path.Combine(folder, mating)]);
            }

            foreach (var design in new[] { "surface-one", "surface-two", "surface-three" })
            {
                Report(
                    $"errormatch surface compensate {design} --out",
                    console,
                    [
                        "surface", "compensate", Repository.PathTo("samples", design, "job.json"), "--measured",
                        Repository.PathTo("samples", design, "measured.csv"), "--out", Path.Combine(folder, design)]);
            }

            var program = Path.Combine(folder, "wave.nc");
            File.WriteAllBytes(program, ProgramBenchmarks.Wave(100_000));
            Report(
                "errormatch nc displace, 10,000 of 100,000 blocks",
                console,
                [
                    "nc", "displace", program, "--blocks", "N450000..N549990", "--normal", "0.02", "--dialect", "fanuc", "--out",
                    Path.Combine(folder, "moved.nc")]);
            return 0;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static void Report(string name, string file, string[] arguments)
    {
        var times = new double[Runs];
        for (var i = 0; i < Runs; i++)
        {
            var watch = Stopwatch.StartNew();
            using var process = Process.Start(
                new ProcessStartInfo(file, arguments)
                {
                    UseShellExecute = false,
                    RedirectStandardOutput = true,
                    RedirectStandardError = true
                })!;
            process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            times[i] = watch.Elapsed.TotalMilliseconds;
            if (process.ExitCode != 0)
            {
                throw new InvalidOperationException($"{name} ended with {process.ExitCode}.");
            }
        }

        Array.Sort(times);
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"{name}: median {times[Runs / 2]:0} ms, fastest {times[0]:0} ms of {Runs} runs"));
    }
}
