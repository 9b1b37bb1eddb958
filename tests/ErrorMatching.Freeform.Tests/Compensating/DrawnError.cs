namespace ErrorMatching.Freeform.Tests;

/// <summary>A family of errors over a piece of 75 x 63 mm: each draw is a function of x and y from -1 to 1, with mean 0 and a standard
/// deviation of one's choice over an even grid.</summary>
internal sealed record DrawnError(string Name, Func<Random, Func<double, double, double>> Draw)
{
    /// <summary>Number of places of the even grid in each direction.</summary>
    public const int Side = 25;

    public static DrawnError Quadratic { get; } = new("quadratic", r =>
    {
        var c = Enumerable.Range(0, 5).Select(_ => Normal(r)).ToArray();
        return (x, y) => (c[0] * x) + (c[1] * y) + (c[2] * ((3 * x * x) - 1)) + (c[3] * x * y) + (c[4] * ((3 * y * y) - 1));
    });

    public static DrawnError Tilt { get; } = new("tilt", r =>
    {
        var a = Between(r, 0, 2 * Math.PI);
        return (x, y) => (Math.Cos(a) * x) + (Math.Sin(a) * y);
    });

    /// <summary>Waves of two and a half points a period on ten points by seven.</summary>
    public static DrawnError ShortWave { get; } = new("wave 21 x 27 mm", r => Product(r, (21, 21), (27, 27)));

    /// <summary>The eight fields that are repeated on every piece.</summary>
    public static IReadOnlyList<DrawnError> Repeating { get; } =
    [
        Quadratic,
        Tilt,
        new("S-shape", r =>
        {
            var (a, b, s) = (Between(r, 0, 2 * Math.PI), Between(r, 2, 4), Between(r, -0.4, 0.4));
            return (x, y) => Math.Tanh(b * ((Math.Cos(a) * x) + (Math.Sin(a) * y) - s));
        }),
        new("bump", r =>
        {
            var (a, b, w) = (Between(r, -0.6, 0.6), Between(r, -0.6, 0.6), Between(r, 0.3, 0.5));
            return (x, y) => Math.Exp(-(((x - a) * (x - a)) + ((y - b) * (y - b))) / (2 * w * w));
        }),
        new("break along a line", r =>
        {
            var (at, alongU, c) = (Between(r, -0.5, 0.5), r.NextDouble() < 0.5, Between(r, -0.12, 0.12));
            return (x, y) => (Math.Pow(Math.Max(0, (alongU ? x : y) - at), 2) + (c * (alongU ? y : x)));
        }),
        ShortWave,
        new("waves 21 to 50 mm", r => Product(r, (21, 50), (21, 50))),
        new("sum of waves", r =>
        {
            var (u, v) = (Wave(r, 75, 24, 45), Wave(r, 63, 28, 50));
            return (x, y) => u(x) + v(y);
        }),
    ];

    public static DrawnError Nothing { get; } = new("noise alone", _ => (_, _) => 0);

    /// <summary>Places of the even grid.</summary>
    public static IReadOnlyList<(double X, double Y)> Even { get; } =
        [.. Enumerable.Range(0, Side * Side).Select(k => ((2.0 * (k % Side) / (Side - 1)) - 1, (2.0 * (k / Side) / (Side - 1)) - 1))];

    /// <summary>A draw whose standard deviation over the even grid is given; zero stays zero.</summary>
    public Func<double, double, double> Of(int seed, double deviation)
    {
        var draw = Draw(new(seed));
        var (mean, own) = Moments([.. Even.Select(p => draw(p.X, p.Y))]);
        return own > 0 ? (x, y) => deviation * (draw(x, y) - mean) / own : draw;
    }

    /// <summary>Mean and standard deviation of all values.</summary>
    public static (double Mean, double Deviation) Moments(IReadOnlyList<double> values)
    {
        var mean = values.Average();
        return (mean, Math.Sqrt(values.Average(v => (v - mean) * (v - mean))));
    }

    public override string ToString() => Name;

    private static Func<double, double, double> Product(Random r, (double From, double To) u, (double From, double To) v)
    {
        var (alongU, alongV) = (Wave(r, 75, u.From, u.To), Wave(r, 63, v.From, v.To));
        return (x, y) => alongU(x) * alongV(y);
    }

    private static Func<double, double> Wave(Random r, double length, double shortest, double longest)
    {
        var (phase, number) = (Between(r, 0, 2 * Math.PI), Math.PI * length / Between(r, shortest, longest));
        return t => Math.Sin((number * t) + phase);
    }

    private static double Between(Random r, double low, double high) => low + ((high - low) * r.NextDouble());

    private static double Normal(Random r) => Math.Sqrt(-2 * Math.Log(1 - r.NextDouble())) * Math.Cos(2 * Math.PI * r.NextDouble());
}
