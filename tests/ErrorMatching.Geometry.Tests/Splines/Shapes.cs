namespace ErrorMatching.Geometry.Tests;

/// <summary>Surfaces with closed forms.</summary>
internal static class Shapes
{
    private static readonly KnotVector Arc = new(2, [0, 0, 0, 1, 1, 1]);
    private static readonly KnotVector Line = new(1, [0, 0, 1, 1]);
    private static readonly double Half = Math.Sqrt(0.5);

    /// <summary>The plane z = 0 over 0..width by 0..depth.</summary>
    public static SplineSurface Plane(double width, double depth) =>
        new(Line, Line, [new(0, 0, 0), new(0, depth, 0), new(width, 0, 0), new(width, depth, 0)]);

    /// <summary>A quarter of a cylinder about the z axis from x to y, u around, v along 0..height.</summary>
    public static SplineSurface Cylinder(double radius, double height) => new(
        Arc,
        Line,
        [
            new(radius, 0, 0),
            new(radius, 0, height),
            new(radius, radius, 0),
            new(radius, radius, height),
            new(0, radius, 0),
            new(0, radius, height)],
        [1, 1, Half, Half, 1, 1]);

    /// <summary>An eighth of a sphere about the origin, all coordinates positive;
    /// u around z, v from the equator to the pole, where all u fall together.</summary>
    public static SplineSurface Sphere(double radius)
    {
        var (poles, weights) = (new List<Point3>(), new List<double>());
        foreach (var (x, y, w) in new[] { (1.0, 0.0, 1.0), (1, 1, Half), (0, 1, 1) })
        {
            foreach (var (out1, z, h) in new[] { (1.0, 0.0, 1.0), (1, 1, Half), (0, 1, 1) })
            {
                poles.Add(new(radius * x * out1, radius * y * out1, radius * z));
                weights.Add(w * h);
            }
        }

        return new(Arc, Arc, [.. poles], [.. weights]);
    }

    /// <summary>A wavy surface over 75 x 63 mm of degree 3 with 8 x 6 pieces, its parameters in millimetres.</summary>
    public static SplineSurface Waves()
    {
        var (u, v) = (
            KnotVector.Clamped(3, [.. Enumerable.Range(0, 9).Select(i => 75.0 * i / 8)]),
            KnotVector.Clamped(3, [.. Enumerable.Range(0, 7).Select(i => 63.0 * i / 6)]));
        var poles = new List<Point3>();
        for (var i = 0; i < u.PoleCount; i++)
        {
            for (var j = 0; j < v.PoleCount; j++)
            {
                var (x, y) = (u.Greville(i), v.Greville(j));
                poles.Add(new(x, y, (6 * Math.Sin(x / 12)) + (4 * Math.Cos(y / 9))));
            }
        }

        return new(u, v, [.. poles]);
    }
}
