namespace ErrorMatching.Freeform.Tests;

/// <summary>Shapes over 75 x 63 mm whose coefficients, places and lengths are drawn: the rule of the fits was not made on them.</summary>
public static class RandomShape
{
    /// <summary>All products of powers up to the square, some millimetres high.</summary>
    public static TrueShape Quadratic(int seed)
    {
        var random = new Random(seed);
        var c = Enumerable.Range(0, 8).Select(k => (k < 5 ? 5 : 2) * Between(random, -1, 1)).ToArray();
        return new($"quadratic {seed}", (x, y) =>
        {
            var (a, b) = ((2 * x / TrueShape.LengthX) - 1, (2 * y / TrueShape.LengthY) - 1);
            return 20 + (c[0] * a) + (c[1] * b) + (c[2] * a * a) + (c[3] * a * b) + (c[4] * b * b) + (c[5] * a * a * b) + (c[6] * a * b * b)
                + (c[7] * a * a * b * b);
        });
    }

    /// <summary>A quadratic that bends otherwise behind a place along either side, anywhere with two lines at least on each side of it; by
    /// how much changes along the break.</summary>
    public static TrueShape Break(int seed)
    {
        var random = new Random(seed);
        var (quadratic, alongX) = (Quadratic(seed + 1_000_000), random.Next(2) == 0);
        var at = alongX ? TrueShape.LengthX * Between(random, 1 / 9.0, 8 / 9.0) : TrueShape.LengthY * Between(random, 1 / 6.0, 5 / 6.0);
        var (size, change) = ((random.Next(2) == 0 ? -1 : 1) * Between(random, 0.005, 0.02), Between(random, -0.4, 0.4));
        return new(
            $"break {seed} at {(alongX ? "x" : "y")} = {at}",
            (x, y) => quadratic.Height(x, y)
                + (
                    size * (
                        1 + (change * (alongX ? y / TrueShape.LengthY : x / TrueShape.LengthX)))
                        * Math.Pow(Math.Max(0, (alongX ? x : y) - at), 2)));
    }

    /// <summary>One to three waves of 75 to 150 mm in any direction, up to half a millimetre high each, on a parabola.</summary>
    public static TrueShape Waves(int seed)
    {
        var random = new Random(seed);
        var waves = Enumerable.Range(0, 1 + random.Next(3)).Select(_ => Wave(random, 75, 150, 0.1, 0.5)).ToArray();
        var (p, q) = (Between(random, -0.002, 0.002), Between(random, -0.002, 0.002));
        return new($"waves {seed}", (x, y) => (p * x * x) + (q * x * y) + waves.Sum(w => w(x, y)));
    }

    /// <summary>A quadratic that bends otherwise behind a line through the middle of the piece, or near it,
    /// in any direction but along the sides.</summary>
    public static TrueShape ObliqueBreak(int seed)
    {
        var random = new Random(seed);
        var (quadratic, angle) = (
            Quadratic(seed + 1_000_000), (random.Next(2) * Math.PI / 2) + Between(random, Math.PI / 12, 5 * Math.PI / 12));
        var (x0, y0) = (TrueShape.LengthX * Between(random, 0.3, 0.7), TrueShape.LengthY * Between(random, 0.3, 0.7));
        var size = (random.Next(2) == 0 ? -1 : 1) * Between(random, 0.005, 0.02);
        return new(
            $"oblique break {seed}",
            (x, y) => quadratic.Height(x, y)
                + (size * Math.Pow(Math.Max(0, ((x - x0) * Math.Cos(angle)) + ((y - y0) * Math.Sin(angle))), 2)));
    }

    /// <summary>Both a break and waves.</summary>
    public static TrueShape BreakAmongWaves(int seed)
    {
        var (broken, waves) = (Break(seed), Waves(seed));
        return new($"{broken.Name} among {waves.Name}", (x, y) => broken.Height(x, y) + waves.Height(x, y));
    }

    /// <summary>An error of a machine: three slow waves in any direction about a mean of 15 um,
    /// with a standard deviation near 6 um.</summary>
    public static TrueShape MachineError(int seed)
    {
        var random = new Random(seed);
        var waves = Enumerable.Range(0, 3).Select(_ => Wave(random, 90, 200, 0.003, 0.007)).ToArray();
        return new($"machine {seed}", (x, y) => 0.015 + waves.Sum(w => w(x, y)));
    }

    private static Func<double, double, double> Wave(Random random, double shortest, double longest, double lowest, double highest)
    {
        var (height, number) = (Between(random, lowest, highest), 2 * Math.PI / Between(random, shortest, longest));
        var (direction, phase) = (Between(random, 0, Math.PI), Between(random, 0, 2 * Math.PI));
        return (x, y) => height * Math.Sin((number * ((x * Math.Cos(direction)) + (y * Math.Sin(direction)))) + phase);
    }

    private static double Between(Random random, double low, double high) => low + ((high - low) * random.NextDouble());
}
