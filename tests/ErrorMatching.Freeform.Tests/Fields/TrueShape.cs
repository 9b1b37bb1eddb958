using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>A surface or an error field whose truth is a formula of x and y in millimetres, over 75 x 63 mm.</summary>
public sealed record TrueShape(string Name, Func<double, double, double> Height)
{
    public const double LengthX = 75;
    public const double LengthY = 63;

    public static TrueShape[] Quadratics { get; } =
    [
        new("One: the same quadratic everywhere", (x, y) => 12 - (0.004 * (x - 20) * (x - 20))),
        new(
            "Two: straight along u, from convex to concave along v",
            (x, y) => 5 + (0.05 * x) - (0.1 * y) + ((0.006 - (0.00016 * x)) * (y - 31) * (y - 31))),
        new(
            "Three: quadratic both ways",
            (x, y) => ((0.005 - (0.00013 * y)) * (x - 37) * (x - 37)) + ((0.004 - (0.0001 * x)) * (y - 30) * (y - 30))),
    ];

    public static TrueShape[] Breaks { get; } =
    [
        new("along u, inside a cell", (x, y) => 8 - (0.004 * (x - 20) * (x - 20)) + (0.012 * Behind(x - 40.3))),
        new(
            "along u, its size changing",
            (x, y) => 8 - (0.003 * (x - 20) * (x - 20)) + ((0.008 + (0.0001 * y)) * Behind(x - 20.1)) + (0.002 * y * y)),
        new("along v", (x, y) => (0.002 * x * x) + (0.01 * Behind(y - 27))),
        new("along v, two lines from the end", (x, y) => (0.002 * x * x) - (0.01 * Behind(y - 47))),
        new("two along u, one on a line", (x, y) => (0.01 * Behind(x - 25)) - (0.015 * Behind(x - 52)) + (0.003 * y * y)),
        new("one each way", (x, y) => (0.01 * Behind(x - 33)) - (0.008 * Behind(y - 26))),
        new("a plane that begins to bend", (x, y) => 0.01 * Behind(x - 61)),
    ];

    public static TrueShape[] Waves { get; } =
    [
        new("a wave along each side", (x, y) => (0.5 * Math.Sin((2 * Math.PI * x / 75) + 0.3)) + (0.3 * Math.Cos(2 * Math.PI * y / 90))),
        new("a product of waves", (x, y) => 0.5 * Math.Sin(2 * Math.PI * x / 90) * Math.Cos(2 * Math.PI * y / 110)),
        new("an oblique wave on a parabola", (x, y) => (0.2 * Math.Sin(2 * Math.PI * (x + y) / 100)) + (0.002 * x * x)),
        new("a hill", (x, y) => 2 * Math.Exp(-(((x - 37) * (x - 37)) + ((y - 31) * (y - 31))) / (2 * 25 * 25))),
    ];

    /// <summary>Errors of machines like the paper's: mean 15 um, standard deviation near 6 um, smooth.</summary>
    public static TrueShape[] MachineErrors { get; } =
    [
        new(
            "waves of guides and a tilt",
            (x, y) => 0.015 + (0.007 * Math.Sin((2 * Math.PI * x / 120) + 0.4)) + (0.004 * Math.Cos((2 * Math.PI * y / 100) + 0.8))
                + (0.00006 * (y - 31))),
        new("an oblique wave too", (x, y) =>
            0.015 + (0.006 * Math.Sin((2 * Math.PI * x / 120) + 0.4)) + (0.004 * Math.Cos((2 * Math.PI * y / 100) + 0.8))
                + (0.003 * Math.Sin(2 * Math.PI * (x - (0.5 * y)) / 110))),
        new(
            "a tool that is deflected where it is steep",
            (x, y) => 0.008 + (0.02 * Math.Exp(-(((x - 10) * (x - 10)) + (0.3 * (y - 40) * (y - 40))) / (2 * 32 * 32)))),
    ];

    public static TrueShape MachineError => MachineErrors[1];

    public Point3 At(double x, double y) => new(x, y, Height(x, y));

    /// <summary>Points on lines along x, with noise in z.</summary>
    public PointGrid Grid(
        int countU = 10, int countV = 7, double noise = 0, int seed = 1, Func<Point3, Point3>? map = null, bool ragged = false)
    {
        var random = new Noise(seed);
        var curves = new List<IReadOnlyList<GridPoint>>();
        for (var j = 0; j < countV; j++)
        {
            var count = ragged ? countU - (j % 3) : countU;
            var curve = new GridPoint[count];
            for (var i = 0; i < count; i++)
            {
                var point = At(LengthX * i / (count - 1.0), LengthY * j / (countV - 1.0));
                point = new(point.X, point.Y, point.Z + (noise * random.Next()));
                curve[i] = new(i, j, map is null ? point : map(point));
            }

            curves.Add(curve);
        }

        return new(curves);
    }

    /// <summary>The heights as measured errors over parameters from 0 to 1.</summary>
    public ErrorSample[] Samples(int countU = 10, int countV = 7, double noise = 0, int seed = 1, bool ragged = false) =>
        [.. Grid(countU, countV, noise, seed, null, ragged).Points.Select((p, k) =>
            new ErrorSample(
                k + 1,
                p.I,
                p.J,
                p.Position.X / LengthX,
                p.Position.Y / LengthY,
                new(p.Position.X, p.Position.Y, 0),
                new(0, 0, 1),
                p.Position.Z))];

    /// <summary>Mean and largest distance of 1000 random true points along the normal of a surface, in micrometers:
    /// the paper's d2.</summary>
    public (double Mean, double Largest) DistanceUm(SplineSurface surface, Func<Point3, Point3>? map = null)
    {
        var distance = new SurfaceDistance(surface);
        return Over(p => distance.To(map is null ? p : map(p)));
    }

    /// <summary>Mean and largest difference of a field over 1000 random places, in micrometers.</summary>
    public (double Mean, double Largest) DifferenceUm(ErrorField field) => Over(p => field.At(p.X / LengthX, p.Y / LengthY) - p.Z);

    private (double Mean, double Largest) Over(Func<Point3, double> of)
    {
        var random = new Random(5);
        var (sum, largest) = (0.0, 0.0);
        for (var k = 0; k < 1000; k++)
        {
            var value = 1000 * Math.Abs(of(At(LengthX * random.NextDouble(), LengthY * random.NextDouble())));
            (sum, largest) = (sum + value, Math.Max(largest, value));
        }

        return (sum / 1000, largest);
    }

    private static double Behind(double t) => t > 0 ? t * t : 0;
}
