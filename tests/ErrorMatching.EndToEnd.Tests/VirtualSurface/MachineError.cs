namespace ErrorMatching.EndToEnd.Tests;

/// <summary>How far a virtual machine's tool is from where its program sends it:
/// the same at each cut (systematic, smooth), and different each time (repeatability).</summary>
internal sealed class MachineError
{
    private readonly (double Kx, double Ky, double Phase, double Amplitude)[] _systematic, _random;
    private readonly double _mean;

    private MachineError((double, double, double, double)[] systematic, (double, double, double, double)[] random, double mean) =>
        (_systematic, _random, _mean) = (systematic, random, mean);

    /// <summary>A machine that goes where it is sent.</summary>
    public static MachineError None { get; } = new([], [], 0);

    /// <summary>A machine. Its systematic error has a mean of 15 um or so and a standard deviation of 6 um over a piece of 75 x 63 mm, as
    /// in tables 2 and 3 of Lee 2019.</summary>
    public static MachineError Systematic(Random random)
    {
        // Half a wave to one wave over the piece: geometric errors of axes, deflection and wear change slowly.
        var waves = Enumerable.Range(0, 3)
            .Select(_ => (Wave(random, 75), Wave(random, 63), 2 * Math.PI * random.NextDouble(), 1 + random.NextDouble()))
            .ToArray();
        var raw = new MachineError(waves, [], 0);
        var values = Grid().Select(p => raw.Along(p.X, p.Y)).ToArray();
        var mean = values.Average();
        var factor = 0.006 / Math.Sqrt(values.Sum(v => (v - mean) * (v - mean)) / (values.Length - 1));
        return new([.. waves.Select(w => (w.Item1, w.Item2, w.Item3, w.Item4 * factor))], [], 0.015 - (mean * factor));
    }

    /// <summary>The machine at its next cut: a standard deviation of 1 um that is never the same again, with waves of 8 to 20 mm.</summary>
    public MachineError NextCut(Random random)
    {
        const int waves = 12;
        return new(
            _systematic,
            [.. Enumerable.Range(0, waves).Select(_ =>
            {
                var (sin, cos) = Math.SinCos(2 * Math.PI * random.NextDouble());
                var k = 2 * Math.PI / (8 + (12 * random.NextDouble()));
                return (k * cos, k * sin, 2 * Math.PI * random.NextDouble(), 0.001 * Math.Sqrt(2.0 / waves));
            })],
            _mean);
    }

    /// <summary>Where the tool really is. What the program wants is raised by the error, and moved sideways by a quarter of it.</summary>
    public Place At(Place wanted)
    {
        var e = Along(wanted.X, wanted.Y);
        return wanted + new Place(e / 4, -e / 4, e);
    }

    private double Along(double x, double y)
    {
        var sum = _mean;
        foreach (var (kx, ky, phase, amplitude) in _systematic)
        {
            sum += amplitude * Math.Sin((kx * x) + (ky * y) + phase);
        }

        foreach (var (kx, ky, phase, amplitude) in _random)
        {
            sum += amplitude * Math.Sin((kx * x) + (ky * y) + phase);
        }

        return sum;
    }

    private static double Wave(Random random, double length) =>
        2 * Math.PI * (0.2 + (0.6 * random.NextDouble())) / length * (random.Next(2) == 0 ? 1 : -1);

    private static IEnumerable<(double X, double Y)> Grid() =>
        from i in Enumerable.Range(0, 16) from j in Enumerable.Range(0, 13) select (75 * i / 15.0, 63 * j / 12.0);
}
