using System.Diagnostics;
using System.Globalization;
using System.Text;

namespace ErrorMatching.Benchmarks;

/// <summary>Programs as CAM systems post them, 3.5 MB each, interpreted by LinuxCNC's interpreter and by ours, on Linux: processor time of
/// whole processes, all of their output read.</summary>
/// <remarks>The bodies of programs of the Debian package linuxcnc-uspace, repeated, and short chords of a surface in the spellings of
/// several postprocessors.</remarks>
internal static class RealPrograms
{
    private const int Bytes = 3_500_000;
    private const int Rounds = 5;

    // The clock of processor time ticks in hundredths of a second, so several short runs are measured together.
    private const int Together = 5;

    private const string Debian = "/usr/share/linuxcnc/ncfiles/";
    private const string FiveAxes =
        "/usr/share/doc/linuxcnc/examples/sample-configs/sim/axis/vismach/5axis/table-rotary-tilting/demos/";

    // Lines that end Debian's programs, call what is not in the file, or need a table of tools.
    private static readonly string[] NotRepeated = ["%", "M2", "M30", "M428", "M429", "T1 M6", "G43"];

    /// <summary>Runs the comparison.</summary>
    public static int Run()
    {
        if (PeerBenchmark.Find() is not { } peer)
        {
            Console.Error.WriteLine("rs274 is missing, so there is nothing to compare with: install the package linuxcnc-uspace.");
            return 1;
        }

        var console = Measurement.Errormatch;
        var folder = Directory.CreateTempSubdirectory("errormatch-real-").FullName;
        try
        {
            Console.WriteLine($"processor time in ms, best of {Rounds} rounds");
            Console.WriteLine("| program | blocks | rs274 -g | nc motion | times as fast | nc check | times as fast |");
            Console.WriteLine("|---|---|---|---|---|---|---|");
            foreach (var (name, head, body) in Programs())
            {
                var file = Path.Combine(folder, "program.ngc");
                var blocks = Write(file, head, body);
                var best = new double[] { double.MaxValue, double.MaxValue, double.MaxValue };
                for (var round = 0; round < Rounds; round++)
                {
                    best[0] = Math.Min(best[0], ProcessorTime(1, peer, ["-g", file], folder));
                    best[1] = Math.Min(best[1], ProcessorTime(Together, console, ["nc", "motion", file, "--dialect", "linuxcnc"], folder));
                    best[2] = Math.Min(best[2], ProcessorTime(Together, console, ["nc", "check", file, "--dialect", "linuxcnc"], folder));
                }

                Console.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"| {name} | {blocks:#,0} | {best[0]:0} | {best[1]:0} | {best[0] / best[1]:0.0} | {best[2]:0} | "
                        + $"{best[0] / best[2]:0.0} |"));
            }

            return 0;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static IEnumerable<(string Name, string Head, IEnumerable<string> Body)> Programs()
    {
        const string Head = "G21 G17 G40 G49 G80 G90 G54 G94\nS12000 M3\nG0 X0 Y0 Z5.\nG1 Z-1. F800.\n";
        foreach (var (what, file) in new[]
        {
            ("3D_Chips.ngc: expressions, N", Debian + "3D_Chips.ngc"),
            ("arcspiral.ngc: arcs by radius, inches", Debian + "arcspiral.ngc"),
            ("impeller-7bl-xyzac.ngc: five axes, F in each block", FiveAxes + "impeller-7bl-xyzac.ngc"),
            ("boat-xyzbc.ngc: five axes, one to three words", FiveAxes + "boat-xyzbc.ngc"),
        })
        {
            if (File.Exists(file))
            {
                var lines = File.ReadAllLines(file)
                    .Where(l => !NotRepeated.Any(n => l.Contains(n, StringComparison.OrdinalIgnoreCase))).ToArray();
                yield return (what, "G94 F500\n", Endless(lines));
            }
            else
            {
                Console.Error.WriteLine($"{file} is missing: install the package linuxcnc-uspace.");
            }
        }

        yield return ("`X1.234 Y5.678 Z0.5`", Head, Chords((_, x, y, z) => Text($"X{x:0.000} Y{y:0.000} Z{z:0.0##}")));
        yield return ("`N10G1X1.2Y5.67Z.5`", Head, Chords((i, x, y, z) => Text($"N{i}G1X{x:0.###}Y{y:0.###}Z{z:#.###}0")));
        yield return (
            "`N10 G1 X1.234 Y5.678 Z0.500 F600.`", Head,
            Chords((i, x, y, z) => Text($"N{10L * i} G1 X{x:0.000} Y{y:0.000} Z{z:0.000} F{600 + (50 * (i % 7))}.")));
        yield return ("`g1 x1.2345 y5.6789 z0.5000`", Head, Chords((_, x, y, z) => Text($"g1 x{x:0.0000} y{y:0.0000} z{z:0.0000}")));
        yield return (
            "`G01 X1.234 Y5.678 Z0.500`, comments", Head,
            Chords((i, x, y, z) => Text($"G01 X{x:0.000} Y{y:0.000} Z{z:0.000}{(i % 10 == 0 ? $" (PASS {i / 40})" : "")}")));
        yield return ("`X1.2` and `Z-.5` by turns", Head, Chords((i, x, _, z) => i % 2 == 0 ? Text($"X{x:0.0##}") : Text($"Z{z:0.0##}")));
        yield return (
            "lines, `G2 X1.234 Y5.678 I1. J0.`, `G3 .. R1.`", Head,
            Chords((i, x, y, _) => (i % 3) switch
            {
                0 => Text($"G1 X{i % 50}. Y{y:0.000}"),
                1 => Text($"G2 X{((i - 1) % 50) + 2}. Y{Row(i - 1):0.000} I1. J0."),
                _ => Text($"G3 X{((i - 2) % 50) + 2}. Y{Row(i - 2) + 2:0.000} R1."),
            }));
    }

    // The raster of a ball over a wave: chords of 0.213 mm, 470 in a row.
    private static IEnumerable<string> Chords(Func<int, double, double, double, string> block)
    {
        for (var i = 0; ; i++)
        {
            var (x, y) = (0.213 * (i / 470 % 2 == 0 ? i % 470 : 469 - (i % 470)), Row(i));
            yield return block(i, x, y, (3 * Math.Sin(0.11 * x) * Math.Cos(0.09 * y)) - 2);
        }
    }

    private static double Row(int block) => 0.3 * (block / 470);

    private static IEnumerable<string> Endless(string[] lines)
    {
        while (true)
        {
            foreach (var line in lines)
            {
                yield return line;
            }
        }
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    private static int Write(string file, string head, IEnumerable<string> body)
    {
        var text = new StringBuilder(head);
        var blocks = head.Count(c => c == '\n') + 1;
        foreach (var line in body)
        {
            text.Append(line).Append('\n');
            blocks++;
            if (text.Length >= Bytes)
            {
                break;
            }
        }

        File.WriteAllText(file, text.Append("M2\n").ToString());
        return blocks;
    }

    // Milliseconds of user and system time of one of several runs.
    private static double ProcessorTime(int runs, string executable, string[] arguments, string home)
    {
        var before = Measurement.ProcessorTimeOfChildren();
        for (var run = 0; run < runs; run++)
        {
            var start = new ProcessStartInfo(executable, arguments)
            {
                UseShellExecute = false,
                RedirectStandardOutput = true,
                RedirectStandardError = true
            };
            (start.Environment["HOME"], start.Environment["DOTNET_TieredPGO"]) = (home, "0");
            using var process = Process.Start(start)!;
            var (output, error) = (process.StandardOutput.BaseStream.CopyToAsync(Stream.Null), process.StandardError.ReadToEndAsync());
            process.WaitForExit();
            Task.WaitAll(output, error);
            if (process.ExitCode != 0)
            {
                throw new InvalidOperationException($"{executable} ended with {process.ExitCode}: {error.Result}");
            }
        }

        return 1000 * (Measurement.ProcessorTimeOfChildren() - before) / runs;
    }
}
