using System.Globalization;
using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Benchmarks;

/// <summary>Files at the limits: the maximum length, lines of a million bytes without an end, and an empty file. Each must be read, in a
/// time that its length explains.</summary>
internal static class HugeFiles
{
    private const int LineBytes = 1_000_000;

    private static readonly string[] Patterns =
    [
        "(", "[", "X[", "AB(", "#", "#[", "\"", "X=IC(", "X=\"", ",R", "X1.5 ", "X#", "O<", "AB", "A=", "A=(", "(\"", "IF ", "X=+", "X-",
        " ", "1 ", "NOT ", "X=NOT ", "X sin[", "#<", "()", "(a)", "XX=", "X1=", "AB[", "%", "/", "N1", "G1", "M3 ", "9", ".", "-", "=", ":",
        "L1 ", "\0", "\u00e4",
    ];

    /// <summary>Runs the figures.</summary>
    public static int Run()
    {
        var folder = Directory.CreateTempSubdirectory("errormatch-huge-").FullName;
        try
        {
            var file = Path.Combine(folder, "huge.nc");
            File.WriteAllBytes(file, []);
            Show(Measurement.OfProcess(1, "an empty file, nc check", Measurement.Errormatch, ["nc", "check", file], folder));
            var worst = new Measurement("", 0, 0);
            foreach (var dialect in NcDialects.Names)
            {
                foreach (var pattern in Patterns)
                {
                    File.WriteAllText(
                        file,
                        "G1 X1 F100\n" + string.Concat(Enumerable.Repeat(pattern, LineBytes / pattern.Length)) + "\nG1 X2\n",
                        Encoding.Latin1);
                    var taken = Time(
                        $"a line of a megabyte of {pattern} ({dialect}), library",
                        () => NcInterpreter.Run(NcProgram.Read(File.ReadAllBytes(file)), NcDialects.Named(dialect)));
                    worst = taken.Seconds > worst.Seconds ? taken : worst;
                }
            }

            Show(worst with { Name = "worst of all: " + worst.Name });
            Fill(file);
            Show(Measurement.OfProcess(1, "a file of 1 GiB, nc check", Measurement.Errormatch, ["nc", "check", file], folder));
            Show(Measurement.OfProcess(
                1,
                "a file of 1 GiB, 101 blocks displaced",
                Measurement.Errormatch,
                ["nc", "displace", file, "--blocks", "N1000000..N1000100", "--normal", "0.02", "--out", Path.Combine(folder, "moved.nc")],
                folder));
            return 0;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    // Blocks of a wave, and a comment that makes the length exact.
    private static void Fill(string file)
    {
        using var stream = File.Create(file);
        stream.Write("G21 G17 G40 G90\nG0 X0. Y0. Z5.\nG1 Z-2. F500.\n"u8);
        for (var i = 1; stream.Position < NcProgram.MaxBytes - 100; i++)
        {
            stream.Write(Encoding.ASCII.GetBytes(string.Create(
                CultureInfo.InvariantCulture, $"N{i} G1 X{i % 100_000 * 0.2:0.000} Y{20 * Math.Sin(0.002 * i):0.000} Z-2.000\n")));
        }

        stream.Write(Encoding.ASCII.GetBytes("(" + new string('-', (int)(NcProgram.MaxBytes - stream.Position - 2)) + ")"));
    }

    private static Measurement Time(string name, Action work)
    {
        var watch = System.Diagnostics.Stopwatch.StartNew();
        work();
        return new(name, watch.Elapsed.TotalSeconds, 0);
    }

    private static void Show(Measurement m) =>
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{m.Name}: {m.Seconds:0.00} "
                + $"s{(m.PeakBytes > 0 ? string.Create(CultureInfo.InvariantCulture, $", peak {m.PeakBytes / 1e6:0} MB") : "")}"));
}
