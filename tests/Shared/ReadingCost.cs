using System.Diagnostics;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.Json;

namespace ErrorMatching.Testing;

/// <summary>Checks that reading costs time in proportion to the input: twice the input takes at most 2.5 times the processor time, and a
/// megabyte less than a second, whatever it contains.</summary>
/// <remarks>An input is a head, a fragment that is repeated, and a tail. Repetition is what makes an algorithm show its order: a list that
/// is searched for every item, a text that is copied for every character, a pattern that is tried from every place.</remarks>
internal static class ReadingCost
{
    // Below this, a difference is noise: a megabyte would take at most a third of a second.
    private const double Noise = 0.08;
    private const double MostRatio = 2.5;
#if DEBUG
    private const double MostSecondsAMegabyte = 5;
#else
    private const double MostSecondsAMegabyte = 1;
#endif

    // Larger inputs, which find more and take longer: ERRORMATCH_READING=2000000.
    private static readonly int? Given = int.TryParse(
        Environment.GetEnvironmentVariable("ERRORMATCH_READING"), NumberStyles.None, CultureInfo.InvariantCulture, out var bytes) ? bytes
            : null;

    /// <summary>Checks a reader with one input after the other.</summary>
    /// <param name="read">Reads the bytes; it may refuse them.</param>
    /// <param name="inputs">Head, repeated fragment and tail of each input.</param>
    public static void IsLinear(Action<byte[]> read, params IEnumerable<(string Head, string Fragment, string Tail)> inputs) =>
        IsLinear(1 << 16, read, inputs);

    /// <summary>The same with inputs of a given length and of twice that.</summary>
    public static void IsLinear(int length, Action<byte[]> read, params IEnumerable<(string Head, string Fragment, string Tail)> inputs)
    {
        length = Given ?? length;
        var found = new List<string>();
        var count = 0;
        foreach (var input in inputs)
        {
            count++;
            // What is done for the first time is not what is measured. A quadratic reader shows itself here already.
            read(Input(input, length / 16));
            var first = Seconds(() => read(Input(input, length / 16)));
            if (first > Noise)
            {
                found.Add(FormattableString.Invariant($"{Shown(input)}: {first:0.000} s for {length / 16} bytes"));
                continue;
            }

            var (small, large) = (Seconds(() => read(Input(input, length))), Seconds(() => read(Input(input, 2 * length))));
            for (var again = 0; again < 4 && IsTooMuch(small, large, length); again++)
            {
                (small, large) = (
                    Math.Min(small, Seconds(() => read(Input(input, length)))),
                    Math.Min(large, Seconds(() => read(Input(input, 2 * length)))));
            }

            if (IsTooMuch(small, large, length))
            {
                found.Add(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{Shown(input)}: {first:0.000} s for {length / 16} bytes, "
                        + $"{small:0.000} s for {length}, {large:0.000} s for {2 * length}"));
            }
        }

        Assert.True(count > 0);
        Assert.True(found.Count == 0, string.Join('\n', found));
    }

    /// <summary>Processor time of the calling thread for some work.</summary>
    public static double Seconds(Action work)
    {
        var before = ThreadSeconds();
        work();
        return ThreadSeconds() - before;
    }

    private static bool IsTooMuch(double small, double large, int length) =>
        large > Noise && (large > MostRatio * small || large * (1 << 20) / (2.0 * length) > MostSecondsAMegabyte);

    private static byte[] Input((string Head, string Fragment, string Tail) input, int length)
    {
        var (head, fragment, tail) = (
            Encoding.UTF8.GetBytes(input.Head), Encoding.UTF8.GetBytes(input.Fragment), Encoding.UTF8.GetBytes(input.Tail));
        var bytes = new List<byte>(length + head.Length + tail.Length);
        bytes.AddRange(head);

        // A sign of its own in every repetition, where they must differ.
        var number = 0;
        while (bytes.Count < length)
        {
            bytes.AddRange(input.Fragment.Contains('§', StringComparison.Ordinal)
                ? Encoding.UTF8.GetBytes(input.Fragment.Replace("§", (number++).ToString(CultureInfo.InvariantCulture),
                    StringComparison.Ordinal))
                : fragment);
        }

        bytes.AddRange(tail);
        return [.. bytes];
    }

    private static string Shown((string Head, string Fragment, string Tail) input) =>
        string.Join(" ",
            new[] { input.Head, input.Fragment, input.Tail }.Select(t => JsonEncodedText.Encode(t.Length > 60 ? t[^60..] : t).ToString()));

    // The thread alone: other tests run at the same time in the same process.
    private static double ThreadSeconds()
    {
        if (!OperatingSystem.IsLinux())
        {
            return Stopwatch.GetTimestamp() / (double)Stopwatch.Frequency;
        }

        const int threadCpuTime = 3;
        Assert.Equal(0, ClockGetTime(threadCpuTime, out var time));
        return time.Seconds + (time.Nanoseconds * 1e-9);
    }

    [DllImport("libc", EntryPoint = "clock_gettime")]
    private static extern int ClockGetTime(int clock, out TimeSpec time);

    [StructLayout(LayoutKind.Sequential)]
    private struct TimeSpec
    {
        public long Seconds;
        public long Nanoseconds;
    }
}
