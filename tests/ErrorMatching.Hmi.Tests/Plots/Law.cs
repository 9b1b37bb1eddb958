using ErrorMatching.Geometry;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Random plots for laws that must always hold.</summary>
internal static class Law
{
    public static Gen<double> Coordinate { get; } = Gen.Choose(-1000, 1000).Select(n => n / 10.0);

    public static Gen<Point2> Point { get; } = Coordinate.Two().Select(p => new Point2(p.Item1, p.Item2));

    public static Gen<PlotView> View { get; } = Gen.Choose(1, 1000)
        .Two()
        .Zip(Point)
        .Select(p => new PlotView(p.Item1.Item1 / 10.0, p.Item1.Item2 / 10.0, p.Item2, 800, 600));

    public static void Holds<T>(Gen<T> gen, Func<T, bool> law, int cases = 500) =>
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(cases), Prop.ForAll(gen.ToArbitrary(), law));
}
