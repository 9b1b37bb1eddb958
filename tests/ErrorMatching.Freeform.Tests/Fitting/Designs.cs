using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Heights z(x, y) over 75 x 63 mm of the paper's kind (Lee 2019, section 2.2) and grids of points on them.</summary>
internal static class Designs
{
    public const double Width = 75;
    public const double Depth = 63;
    private const double K = 0.004;

    /// <summary>Identical quadratic curves along u, straight along v.</summary>
    public static double One(double x, double y) => 24 + (K * Square(x - 50));

    /// <summary>Straight along u with varying slope, along v quadratic from convex to concave.</summary>
    public static double Two(double x, double y) => 24 + (K * Square(y - 31.5) * ((2 * x / Width) - 1));

    /// <summary>Quadratic both ways, from convex to concave.</summary>
    public static double Three(double x, double y) =>
        24 + (K * ((Square(y - 31.5) * ((2 * x / Width) - 1)) + (Square(x - 37.5) * ((2 * y / Depth) - 1))));

    /// <summary>Waves of two lengths, for which no polynomial of low degree will do.</summary>
    public static double Waves(double x, double y) => 20 + Math.Sin(x / 12) + (0.5 * Math.Cos((y / 15) + (x / 40)));

    public static Func<double, double, double> Named(string name) => name switch
    {
        "one" => One,
        "two" => Two,
        "three" => Three,
        "waves" => Waves,
        _ => throw new ArgumentOutOfRangeException(nameof(name), name, "one, two, three or waves"),
    };

    /// <summary>A grid of count x curves points with noise of a standard deviation along z.</summary>
    public static PointGrid Grid(Func<double, double, double> height, int count = 10, int curves = 7, double noiseMm = 0, int seed = 1)
    {
        var random = new Gaussian(seed);
        return new([.. Enumerable.Range(0, curves).Select(j => (IReadOnlyList<GridPoint>)[.. Enumerable.Range(0, count).Select(i =>
        {
            var (x, y) = (Width * i / (count - 1), Depth * j / (curves - 1));
            return new GridPoint(i, j, new(x, y, height(x, y) + (noiseMm * random.Next())));
        })])]);
    }

    /// <summary>1,000 places of the true surface, the same on every run.</summary>
    public static Point3[] Truth(Func<double, double, double> height)
    {
        // Fractions of multiples of two irrational numbers fill the square evenly (R. C. Steckley and M. Roberts' plastic number).
        return [.. Enumerable.Range(1, 1000).Select(k =>
        {
            var (x, y) = (Width * Fraction(k * 0.7548776662466927), Depth * Fraction(k * 0.5698402909980532));
            return new Point3(x, y, height(x, y));
        })];
    }

    private static double Fraction(double x) => x - Math.Floor(x);

    private static double Square(double x) => x * x;
}
