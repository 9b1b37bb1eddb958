using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>Random clamped B-splines of the size of a workpiece, every other one rational.</summary>
internal static class RandomSpline
{
    public static SplineCurve Curve(Random random)
    {
        var knots = Knots(random);
        return new(knots, Poles(random, knots.PoleCount), Weights(random, knots.PoleCount));
    }

    public static SplineSurface Surface(Random random)
    {
        var (u, v) = (Knots(random), Knots(random));
        return new(u, v, Poles(random, u.PoleCount * v.PoleCount), Weights(random, u.PoleCount * v.PoleCount));
    }

    /// <summary>A gently curved surface over about 75 x 63 mm, as a workpiece has.</summary>
    public static SplineSurface Workpiece(Random random)
    {
        var (u, v) = (Knots(random), Knots(random));
        var poles = new List<Point3>();
        for (var i = 0; i < u.PoleCount; i++)
        {
            for (var j = 0; j < v.PoleCount; j++)
            {
                var (a, b) = ((u.Greville(i) - u.Start) / (u.End - u.Start), (v.Greville(j) - v.Start) / (v.End - v.Start));
                poles.Add(new(75 * a, 63 * b, (20 * a * (1 - a)) + (8 * b) + random.NextDouble()));
            }
        }

        return new(u, v, [.. poles], Weights(random, poles.Count));
    }

    /// <summary>A parameter between the first and the last.</summary>
    public static double Inside(Random random, KnotVector knots) => knots.Start + ((knots.End - knots.Start) * random.NextDouble());

    private static KnotVector Knots(Random random)
    {
        var degree = 2 + random.Next(4);
        var breaks = new List<double> { (10 * random.NextDouble()) - 5 };
        for (var i = 0; i <= random.Next(4); i++)
        {
            breaks.Add(breaks[^1] + 0.5 + random.NextDouble());
        }

        return KnotVector.Clamped(degree, [.. breaks], 1 + random.Next(degree - 1));
    }

    private static Point3[] Poles(Random random, int count) =>
        [
            .. Enumerable.Range(0, count).Select(_ => new Point3(
                100 * random.NextDouble(), 100 * random.NextDouble(), 100 * random.NextDouble()))];

    private static double[] Weights(Random random, int count) =>
        random.Next(2) == 0 ? [] : [.. Enumerable.Range(0, count).Select(_ => 0.5 + random.NextDouble())];
}
