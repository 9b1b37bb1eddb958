using System.Diagnostics;
using System.Globalization;
using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Benchmarks;

/// <summary>The same program, interpreted by LinuxCNC's interpreter and by ours, in one run: wall time and peak memory of whole processes,
/// and of the library working from memory.</summary>
internal static class PeerBenchmark
{
    private const int DefaultBlocks = 1_000_000;
    private const int Runs = 3;

    /// <summary>Runs the comparison.</summary>
    /// <param name="blocks">Number of blocks; null for a million.</param>
    public static int Run(string? blocks)
    {
        if (Find() is not { } peer)
        {
            Console.Error.WriteLine("rs274 is missing, so there is nothing to compare with: install the package linuxcnc-uspace.");
            return 1;
        }

        var count = blocks is null ? DefaultBlocks : int.Parse(blocks, CultureInfo.InvariantCulture);
        var folder = Directory.CreateTempSubdirectory("errormatch-peer-").FullName;
        try
        {
            var program = Program(count);
            var file = Path.Combine(folder, "program.ngc");
            File.WriteAllBytes(file, program);
            var console = Measurement.Errormatch;
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture, $"{count} blocks, {program.Length / 1e6:0.0} MB, best of {Runs} runs"));
            var reference = Measurement.OfProcess(Runs, "rs274 -g, whole process", peer, ["-g", file], folder);
            var read = NcProgram.Read(program, NcDialects.LinuxCnc.Syntax);
            NcInterpreter.Run(read, NcDialects.LinuxCnc);
            Measurement[] ours =
            [
                Measurement.OfProcess(
                    Runs, "errormatch nc motion, whole process", console, ["nc", "motion", file, "--dialect", "linuxcnc"], folder),
                Measurement.OfProcess(
                    Runs, "errormatch nc check, whole process", console, ["nc", "check", file, "--dialect", "linuxcnc"], folder),
                Memory(
                    "the library, from bytes in memory to motions",
                    () => NcInterpreter.Run(NcProgram.Read(program, NcDialects.LinuxCnc.Syntax), NcDialects.LinuxCnc)),
                Memory("the library, interpreting alone", () => NcInterpreter.Run(read, NcDialects.LinuxCnc)),
            ];
            Console.WriteLine("| what | seconds | million blocks/s | peak MB | times rs274 |");
            Console.WriteLine("|---|---|---|---|---|");
            foreach (var m in ours.Prepend(reference))
            {
                Console.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"| {m.Name} | {m.Seconds:0.000} | {count / m.Seconds / 1e6:0.00} | {m.PeakBytes / 1e6:0} | "
                        + $"{reference.Seconds / m.Seconds:0.0} |"));
            }

            return 0;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    /// <summary>A program of straight cuts in three axes in the style of a postprocessor, about 38 bytes per block, in words that both
    /// interpreters read.</summary>
    private static byte[] Program(int blocks)
    {
        var text = new StringBuilder(blocks * 40);
        text.Append("N1 G21 G17 G90 G94 G40 G54\nN2 G0 X0.0000 Y0.0000 Z5.0000\nN3 G1 Z-1.0000 F500.0\n");
        for (var i = 3; i < blocks - 1; i++)
        {
            var (x, y, z) = (100 * Math.Sin(i * 1e-3), 100 * Math.Cos(i * 1.7e-3), -1 - (0.5 * Math.Sin(i * 1e-4)));
            text.Append(CultureInfo.InvariantCulture, $"N{i % 99999:00000} G01 X{x:0.0000} Y{y:0.0000} Z{z:0.0000}\n");
        }

        return Encoding.ASCII.GetBytes(text.Append("M2\n").ToString());
    }

    // In memory, the peak is what one run allocates: nothing of it is collected before the end.
    private static Measurement Memory(string name, Action work)
    {
        var best = double.MaxValue;
        var allocated = 0L;
        for (var run = 0; run < Runs; run++)
        {
            GC.Collect();
            var before = GC.GetTotalAllocatedBytes(precise: true);
            var watch = Stopwatch.StartNew();
            work();
            best = Math.Min(best, watch.Elapsed.TotalSeconds);
            allocated = GC.GetTotalAllocatedBytes(precise: true) - before;
        }

        return new(name, best, allocated);
    }

    /// <summary>LinuxCNC's interpreter on the path; null if it is not installed.</summary>
    public static string? Find() =>
        (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Select(f => Path.Combine(f, "rs274"))
        .FirstOrDefault(File.Exists);
}
