using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Random surfaces of the size of a workpiece that the tool reaches along z: polynomial or rational, whole or limited.</summary>
internal static class SurfaceSamples
{
    /// <summary>A surface whose numbers have all their digits.</summary>
    /// <param name="seed">Which one.</param>
    /// <param name="limited">True for a region with a hole.</param>
    public static PartSurface Of(int seed, bool limited = false)
    {
        var random = new Random(seed);
        var (u, v) = (Knots(random), Knots(random));
        var poles = new List<Point3>();
        var weights = new List<double>();
        for (var i = 0; i < u.PoleCount; i++)
        {
            for (var j = 0; j < v.PoleCount; j++)
            {
                poles.Add(new(
                    (10 * u.Greville(i)) + (0.01 * random.NextDouble()),
                    (10 * v.Greville(j)) + (0.01 * random.NextDouble()),
                    random.NextDouble()));
                weights.Add(seed % 2 == 0 ? 1 : 0.8 + (0.4 * random.NextDouble()));
            }
        }

        var surface = new SplineSurface(u, v, [.. poles], [.. weights]);
        return new(
            $"TOP {seed} of a piece",
            surface,
            limited ? new([Circle(u, v, 0.45), Circle(u, v, 0.1 + (0.2 * random.NextDouble()))]) : SurfaceRegion.Whole,
            1);
    }

    private static List<Point2> Circle(KnotVector u, KnotVector v, double size)
    {
        var points = new List<Point2>();
        for (var k = 0; k < 60; k++)
        {
            var (sin, cos) = Math.SinCos(Math.Tau * k / 60);
            points.Add(new(u.Start + ((u.End - u.Start) * (0.5 + (size * cos))), v.Start + ((v.End - v.Start) * (0.5 + (size * sin)))));
        }

        return points;
    }

    private static KnotVector Knots(Random random)
    {
        var degree = 1 + random.Next(5);
        var breaks = new List<double> { random.NextDouble() };
        for (var i = 0; i <= random.Next(4); i++)
        {
            breaks.Add(breaks[^1] + 0.5 + random.NextDouble());
        }

        return KnotVector.Clamped(degree, breaks.ToArray(), 1 + random.Next(degree));
    }
}
