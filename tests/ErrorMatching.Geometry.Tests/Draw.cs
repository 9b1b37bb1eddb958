using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

/// <summary>Random geometry of the size of a workpiece for laws that must always hold.</summary>
internal static class Draw
{
    /// <summary>A coordinate between -100 and 100 mm in steps of 0.001, so that touching cases do occur.</summary>
    public static Gen<double> Coordinate { get; } = Gen.Choose(-100_000, 100_000).Select(n => n / 1000.0);

    public static Gen<Point2> Point { get; } = Coordinate.Two().Select(p => new Point2(p.Item1, p.Item2));

    public static Gen<double> Radius { get; } = Gen.Choose(100, 80_000).Select(n => n / 1000.0);

    public static Gen<Angle> Angle { get; } = Gen.Choose(-180_000, 180_000).Select(n => Geometry.Angle.FromDegrees(n / 1000.0));

    public static Gen<Line2> Line { get; } = Point.Zip(Angle).Select(p => new Line2(p.Item1, Vector2.FromDirection(p.Item2)));

    public static Gen<Segment2> Segment { get; } = Point.Two().Select(p => new Segment2(p.Item1, p.Item2));

    public static Gen<Circle2> Circle { get; } = Point.Zip(Radius).Select(p => new Circle2(p.Item1, p.Item2));

    public static Gen<Arc2> Arc { get; } = Circle.Zip(Angle.Two())
        .Select(p => new Arc2(p.Item1.Center, p.Item1.Radius, p.Item2.Item1, p.Item2.Item2 * 1.9));

    public static Gen<RigidTransform2> Transform { get; } = Gen.Elements(Mirror.None, Mirror.X, Mirror.Y).Zip(Angle).Zip(Point)
        .Select(p => new RigidTransform2(p.Item1.Item1, p.Item1.Item2, p.Item2 - Point2.Origin));

    /// <summary>A fixed stream of numbers in [-1, 1), the same on every run.</summary>
    public static double[] Noise(int seed, int count)
    {
        var state = (ulong)seed + 0x9E3779B97F4A7C15UL;
        var noise = new double[count];
        for (var i = 0; i < count; i++)
        {
            state += 0x9E3779B97F4A7C15UL;
            var mixed = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9UL;
            mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBUL;
            noise[i] = ((mixed ^ (mixed >> 31)) >> 11) * Math.ScaleB(1, -52) - 1;
        }

        return noise;
    }

    /// <summary>Checks a law on many random cases and throws with the smallest case that breaks it.</summary>
    public static void Law<T>(Gen<T> gen, Func<T, bool> law, int cases = 1000) =>
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(cases), Prop.ForAll(gen.ToArbitrary(), law));
}
