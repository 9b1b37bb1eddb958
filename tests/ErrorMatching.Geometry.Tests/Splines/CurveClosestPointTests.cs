using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

public sealed class CurveClosestPointTests
{
    private static readonly Gen<Point3> Near = Draw.Coordinate.Three().Select(c => new Point3(c.Item1, c.Item2, c.Item3));

    private static readonly SplineCurve QuarterCircle = new(
        new(2, [0, 0, 0, 1, 1, 1]), [new(20, 0, 0), new(20, 20, 0), new(0, 20, 0)], [1, Math.Sqrt(0.5), 1]);

    [Fact]
    public void Distance_from_a_quarter_circle_is_that_of_its_closed_form() => Draw.Law(Near, p =>
    {
        var foot = QuarterCircle.ClosestPoint(p);
        var across = p.X >= 0 && p.Y >= 0
            ? Math.Abs(Math.Sqrt((p.X * p.X) + (p.Y * p.Y)) - 20)
            : Math.Min(new Vector3(p.X - 20, p.Y, 0).Length, new Vector3(p.X, p.Y - 20, 0).Length);
        return Math.Abs(foot.Distance - Math.Sqrt((across * across) + (p.Z * p.Z))) < 1e-11 && foot.Accuracy <= 1e-7;
    });

    [Fact]
    public void No_place_of_a_dense_row_is_closer() => Draw.Law(
        DrawSpline.Curve.Zip(Near),
        c =>
        {
            var (curve, p) = c;
            var foot = curve.ClosestPoint(p);
            var near = curve.ClosestPoint(p, curve.Knots.Start, 1e-7);
            var least = Enumerable.Range(0, 2001).Min(i => (curve.PointAt(DrawSpline.Inside(curve.Knots, (i / 1000.0) - 1)) - p).Length);
            return foot.Distance <= least + 1e-10
                && Math.Abs(near.Distance - foot.Distance) <= 1e-7
                && (curve.PointAt(foot.T) - foot.Position).Length < 1e-9
                && foot.Accuracy <= 1e-7;
        },
        200);

    [Fact]
    public void Points_on_a_curve_are_their_own_feet() => Draw.Law(Gen.Choose(0, 1000), t =>
        Math.Abs(QuarterCircle.ClosestPoint(QuarterCircle.PointAt(t / 1000.0)).T - (t / 1000.0)) < 1e-12);
}
