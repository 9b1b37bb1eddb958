using System.Diagnostics;
using System.Globalization;
using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Benchmarks;

/// <summary>A million blocks of contour under cutter compensation, lines and arcs with inside and outside corners: processor time of all
/// threads from the bytes in memory to the path of the tool's center.</summary>
internal static class CompensatedBlocks
{
    private const int Runs = 5;

    /// <summary>Runs the figures.</summary>
    /// <param name="blocks">Number of blocks; null for a million.</param>
    public static int Run(string? blocks)
    {
        var count = blocks is null ? 1_000_000 : int.Parse(blocks, CultureInfo.InvariantCulture);
        var bytes = Program(count);
        var path = Read(bytes);
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"{count} blocks, {bytes.Length / 1e6:0.0} MB, processor time, best of {Runs} runs"));
        Console.WriteLine("| what | seconds |");
        Console.WriteLine("|---|---|");
        Show("reading and interpreting", () => Read(bytes).Motions.Length);
        Show("from there, the path of the tool's center", () => Center(path));
        Show("from there, only whether the control would stop", () => CompensatedPath.Check(path) is { } stop ? throw Stopped(stop) : 0);
        Show("reading, interpreting, and the path of the tool's center", () => Center(Read(bytes)));
        return 0;
    }

    private static int Center(NcPath path) =>
        CompensatedPath.Of(path) is { Refusal: null } center ? center.Motions.Count : throw Stopped(CompensatedPath.Of(path).Refusal!);

    private static InvalidOperationException Stopped(Refusals.Refusal refusal) => new(refusal.Message);

    private static void Show(string what, Func<int> work)
    {
        var best = double.MaxValue;
        for (var run = 0; run < Runs; run++)
        {
            GC.Collect();
            using var process = Process.GetCurrentProcess();
            var before = process.TotalProcessorTime;
            work();
            process.Refresh();
            best = Math.Min(best, (process.TotalProcessorTime - before).TotalSeconds);
        }

        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"| {what} | {best:0.00} |"));
    }

    private static NcPath Read(byte[] bytes) => NcInterpreter.Run(NcProgram.Read(bytes, NcDialects.LinuxCnc.Syntax), NcDialects.LinuxCnc);

    // Waves of two lines and two half circles, each corner of 45 degrees: two inside, two outside.
    private static byte[] Program(int blocks)
    {
        var text = new StringBuilder(blocks * 40);
        text.Append("N1 G21 G17 G90 G91.1 G94 G40\nN2 G0 X-20 Y0 Z5\nN3 G1 Z-1 F500\nN4 G41.1 D0.2 G1 X0 Y0\n");
        for (var i = 0; i < blocks - 6; i++)
        {
            var (x, y) = (i + 1, i % 4 < 2 ? 1 : 0);
            var words = (i % 4) switch { 1 => "G2", 3 => "G3", _ => "G1" };
            var center = i % 2 == 1 ? " I0.5000 J0.0000" : "";
            text.Append(CultureInfo.InvariantCulture, $"N{i % 99999:00000} {words} X{x:0.0000} Y{y:0.0000}{center}\n");
        }

        return Encoding.ASCII.GetBytes(text.Append("N5 G40 G1 Y30\nM2\n").ToString());
    }
}
