using System.Globalization;
using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Benchmarks;

/// <summary>A program of a million blocks, a tenth of them displaced: whole processes as a user runs them, with their peak memory as a
/// multiple of the file size.</summary>
internal static class MillionBlocks
{
    private const int Runs = 7;

    /// <summary>Runs the figures.</summary>
    /// <param name="blocks">Number of blocks; null for a million.</param>
    public static int Run(string? blocks)
    {
        var count = blocks is null ? 1_000_000 : int.Parse(blocks, CultureInfo.InvariantCulture);
        var folder = Directory.CreateTempSubdirectory("errormatch-million-").FullName;
        try
        {
            var file = Path.Combine(folder, "wave.nc");
            var bytes = Write(file, count);
            var range = $"N{10L * (count / 20 * 9)}..N{(10L * (count / 20 * 11)) - 10}";
            string[] Displace(string how, string by) =>
                ["nc", "displace", file, "--dialect", "fanuc", "--blocks", range, how, by, "--out", Path.Combine(folder, "moved.nc")];
            var console = Measurement.Errormatch;
            Measurement[] measured =
            [
                Measurement.OfProcess(Runs, "errormatch nc displace --normal", console, Displace("--normal", "0.02"), folder),
                Measurement.OfProcess(Runs, "errormatch nc displace --by", console, Displace("--by", "0.02,0.01"), folder),
                Measurement.OfProcess(Runs, "errormatch nc check", console, ["nc", "check", file, "--dialect", "fanuc"], folder),
            ];
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture, $"{count} blocks, {bytes / 1e6:0.0} MB, {range} displaced, best of {Runs} runs"));
            Console.WriteLine("| what | seconds | peak MB | times the file |");
            Console.WriteLine("|---|---|---|---|");
            foreach (var m in measured)
            {
                Console.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"| {m.Name} | {m.Seconds:0.000} | {m.PeakBytes / 1e6:0} | {(double)m.PeakBytes / bytes:0.00} |"));
            }

            var program = NcProgram.Read(File.ReadAllBytes(file), NcDialects.FanucMill.Syntax);
            var best = double.MaxValue;
            for (var run = 0; run < Runs; run++)
            {
                GC.Collect();
                var watch = System.Diagnostics.Stopwatch.StartNew();
                NcInterpreter.Run(program, NcDialects.FanucMill);
                best = Math.Min(best, watch.Elapsed.TotalSeconds);
            }

            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture, $"Interpreting from memory: {count / best / 1e6:0.0} million blocks a second."));
            return 0;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    /// <summary>Writes a wave of closely spaced points, about 38 bytes per block.</summary>
    private static long Write(string file, int blocks)
    {
        using var text = new StreamWriter(file, append: false, new UTF8Encoding(false)) { NewLine = "\n" };
        text.WriteLine("%\nO1000\nN10 G21 G17 G40 G90 G54\nN20 G0 X0. Y0. Z5.\nN30 G1 Z-2. F500.");
        for (var i = 4; i < blocks - 4; i++)
        {
            text.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"N{i * 10L} G1 X{0.2 * i:0.000} Y{20 * Math.Sin(0.002 * i):0.000} Z-2.000{(i % 50 == 0 ? " F800." : "")}"));
        }

        text.WriteLine("M30\n%");
        text.Flush();
        return text.BaseStream.Length;
    }
}
