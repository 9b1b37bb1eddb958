using ErrorMatching.Freeform;

namespace ErrorMatching.Benchmarks;

/// <summary>Heights over 75 x 63 mm of the kinds that surface fits are tested with.</summary>
public static class FitShape
{
    private const double Width = 75;
    private const double Depth = 63;

    /// <summary>The names of the shapes.</summary>
    public static IReadOnlyList<string> Names { get; } = ["quadratic", "break", "waves", "break among waves"];

    /// <summary>A grid of points on a shape: 70 (10 by 7) or 5,000 (100 by 50).</summary>
    public static PointGrid Grid(string name, int points, double noiseUm)
    {
        var (along, across) = points switch
        {
            70 => (10, 7),
            5000 => (100, 50),
            _ => throw new ArgumentOutOfRangeException(nameof(points), points, "70 or 5000")
        };
        var random = new Random(1);
        return new([.. Enumerable.Range(0, across).Select(j => (IReadOnlyList<GridPoint>)[.. Enumerable.Range(0, along).Select(i =>
        {
            var (x, y) = (Width * i / (along - 1), Depth * j / (across - 1));
            return new GridPoint(i, j, new(x, y, Height(name, x, y) + (noiseUm / 1000 * Normal(random))));
        })])]);
    }

    private static double Height(string name, double x, double y) => name switch
    {
        "quadratic" => 24 + (0.004 * ((Square(y - 31.5) * ((2 * x / Width) - 1)) + (Square(x - 37.5) * ((2 * y / Depth) - 1)))),
        "break" => 8 - (0.003 * Square(x - 20)) + ((0.008 + (0.0001 * y)) * Square(Math.Max(0, x - 40.3))),
        "waves" => 0.5 * Math.Sin(2 * Math.PI * x / 90) * Math.Cos(2 * Math.PI * y / 110),
        "break among waves" => Height("break", x, y) + Height("waves", x, y),
        _ => throw new ArgumentOutOfRangeException(nameof(name), name, string.Join(", ", Names)),
    };

    private static double Square(double x) => x * x;

    // Box-Muller transform.
    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
