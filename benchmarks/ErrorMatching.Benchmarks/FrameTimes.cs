using System.Diagnostics;
using System.Globalization;
using Avalonia;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>Times of frames in ms.</summary>
/// <param name="Ordered">Each frame's time, shortest first.</param>
/// <param name="Processor">Processor time of the whole process per frame, which other programs on the computer hardly change.</param>
internal sealed record FrameTimes(double[] Ordered, double Processor)
{
    private const int Warm = 20, Frames = 100;

    public double Median => Ordered[Ordered.Length / 2];

    public double Longest => Ordered[^1];

    public double NinetyNine => Ordered[Ordered.Length * 99 / 100];

    /// <summary>Writes the head of a table of <see cref="Report"/>.</summary>
    public static void Head() => Console.WriteLine(
        "| size | what | median | 99 of 100 | longest | processor time |\n|---|---|---|---|---|---|");

    /// <summary>Writes a row of the table.</summary>
    public static void Report(Size size, string what, FrameTimes times) => Console.WriteLine(string.Create(
        CultureInfo.InvariantCulture,
        $"| {Shown(size)} | {what} | {times.Median:0.0} | {times.NinetyNine:0.0} | {times.Longest:0.0} | {times.Processor:0.0} |"));

    /// <summary>A size in words.</summary>
    public static string Shown(Size size) => string.Create(CultureInfo.InvariantCulture, $"{size.Width:0}x{size.Height:0}");

    /// <summary>How far to pan before a frame: to and fro.</summary>
    public static double Step(int i) => i % 100 < 50 ? 9 : -9;

    /// <summary>Does something and draws a frame, again and again.</summary>
    public static FrameTimes Of(ScreenUser user, Action<int> act)
    {
        var times = new List<double>();
        var before = TimeSpan.Zero;
        for (var i = -Warm; i < Frames; i++)
        {
            before = i == 0 ? Environment.CpuUsage.TotalTime : before;
            var watch = Stopwatch.StartNew();
            act(i + Warm);
            user.Settle(1);
            if (i >= 0)
            {
                times.Add(watch.Elapsed.TotalMilliseconds);
            }
        }

        return new([.. times.Order()], (Environment.CpuUsage.TotalTime - before).TotalMilliseconds / Frames);
    }
}
