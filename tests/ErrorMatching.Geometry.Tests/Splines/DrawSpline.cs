using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

/// <summary>Random B-splines of the size of a workpiece: degrees 1 to 5, knots repeated up to the degree, uneven, clamped or not,
/// rational or not.</summary>
internal static class DrawSpline
{
    public static Gen<KnotVector> Knots { get; } = Gen.Choose(1, 5).Zip(Gen.Choose(0, 1_000_000)).Select(p => KnotsOf(p.Item1, p.Item2));

    public static Gen<SplineCurve> Curve { get; } = Knots.Zip(Gen.Choose(0, 1_000_000)).Select(
        p => new SplineCurve(p.Item1, Poles(p.Item1.PoleCount, p.Item2), Weights(p.Item1.PoleCount, p.Item2)));

    public static Gen<SplineSurface> Surface { get; } = Knots.Zip(Knots).Zip(Gen.Choose(0, 1_000_000)).Select(p =>
    {
        var count = p.Item1.Item1.PoleCount * p.Item1.Item2.PoleCount;
        return new SplineSurface(p.Item1.Item1, p.Item1.Item2, Poles(count, p.Item2), Weights(count, p.Item2));
    });

    /// <summary>A place inside a range for a number between -1 and 1.</summary>
    public static double Inside(KnotVector knots, double noise) => knots.Start + ((knots.End - knots.Start) * (0.5 + (0.5 * noise)));

    private static KnotVector KnotsOf(int degree, int seed)
    {
        var noise = Draw.Noise(seed, 40);
        var breaks = new List<double> { 10 * noise[0] };
        for (var i = 0; i < 2 + (int)(2 * (1 + noise[1])); i++)
        {
            breaks.Add(breaks[^1] + 0.05 + (2 * Math.Abs(noise[i + 2])));
        }

        var clamped = noise[10] > -0.6;
        if (!clamped)
        {
            while (breaks.Count < 2 * (degree + 1))
            {
                breaks.Add(breaks[^1] + 0.1 + Math.Abs(noise[breaks.Count + 10]));
            }

            return new(degree, [.. breaks]);
        }

        var values = new List<double>();
        for (var i = 0; i < breaks.Count; i++)
        {
            var times = i == 0 || i == breaks.Count - 1 ? degree + 1 : 1 + (int)(degree * 0.4999 * (1 + noise[30 + (i % 9)]));
            values.AddRange(Enumerable.Repeat(breaks[i], times));
        }

        return new(degree, [.. values]);
    }

    private static Point3[] Poles(int count, int seed)
    {
        var noise = Draw.Noise(seed + 7, 3 * count);
        return [
            .. Enumerable.Range(0, count).Select(i => new Point3(100 * noise[3 * i], 100 * noise[(3 * i) + 1], 100 * noise[(3 * i) + 2]))];
    }

    private static double[] Weights(int count, int seed) => seed % 2 == 0 ? [] : [.. Draw.Noise(seed + 9, count).Select(x => 1.2 + x)];
}
