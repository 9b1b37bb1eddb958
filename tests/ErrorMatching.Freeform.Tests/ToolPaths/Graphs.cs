using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>The paper's designs as functions z(x, y), and distances from them found on these functions.</summary>
internal static class Graphs
{
    public static double Height(int design, double x, double y) => design switch
    {
        1 => 30 - (0.004 * x * x),
        2 => 24 + (0.004 * (y - 31.5) * (y - 31.5) * ((2 * x / 75) - 1)),
        _ => 24 + (0.004 * (((y - 31.5) * (y - 31.5) * ((2 * x / 75) - 1)) + ((x - 37.5) * (x - 37.5) * ((2 * y / 63) - 1)))),
    };

    /// <summary>Distance of a point from a design over its rectangle.</summary>
    public static double DistanceTo(int design, Point3 p) => DistanceTo((x, y) => Height(design, x, y), 75, 63, p);

    /// <summary>Distance of a point from a graph over a rectangle: the best place of a grid,
    /// then a search with smaller and smaller steps.</summary>
    public static double DistanceTo(Func<double, double, double> z, double width, double height, Point3 p)
    {
        var (x, y, best) = (0.0, 0.0, double.PositiveInfinity);
        for (var i = -20; i <= 20; i++)
        {
            for (var j = -20; j <= 20; j++)
            {
                Try(p.X + (i * 0.25), p.Y + (j * 0.25));
            }
        }

        for (var step = 0.125; step > 1e-7; step /= 2)
        {
            for (var moved = true; moved;)
            {
                var before = best;
                var (cx, cy) = (x, y);
                Try(cx + step, cy);
                Try(cx - step, cy);
                Try(cx, cy + step);
                Try(cx, cy - step);
                moved = best < before;
            }
        }

        return best;

        void Try(double a, double b)
        {
            (a, b) = (Math.Clamp(a, 0, width), Math.Clamp(b, 0, height));
            var distance = (new Point3(a, b, z(a, b)) - p).Length;
            if (distance < best)
            {
                (x, y, best) = (a, b, distance);
            }
        }
    }
}
