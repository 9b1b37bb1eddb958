using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

public sealed class SplineEvaluationTests
{
    // Bernstein form of x = 10 u, y = 8 v, z = 3 u^2 - 2 u v + v^2: poles of degree 2 by blossoming each monomial.
    private static readonly SplineSurface Quadratic = new(
        new(2, [0, 0, 0, 1, 1, 1]),
        new(2, [0, 0, 0, 1, 1, 1]),
        [
            new(0, 0, 0), new(0, 4, 0), new(0, 8, 1), new(5, 0, 0), new(5, 4, -0.5), new(5, 8, 0), new(10, 0, 3), new(10, 4, 2),
            new(10, 8, 2)]);

    [Theory]
    [InlineData(0, 0)]
    [InlineData(0.3, 0.8)]
    [InlineData(1, 1)]
    [InlineData(0.75, 0.1)]
    public void Quadratic_surface_has_the_derivatives_of_its_formula(double u, double v)
    {
        var at = Quadratic.At(u, v);
        Near(new(10 * u, 8 * v, (3 * u * u) - (2 * u * v) + (v * v)), at.Position);
        Near(new(10, 0, (6 * u) - (2 * v)), at.Du);
        Near(new(0, 8, (-2 * u) + (2 * v)), at.Dv);
        Near(new(0, 0, 6), at.Duu);
        Near(new(0, 0, -2), at.Duv);
        Near(new(0, 0, 2), at.Dvv);
    }

    [Fact]
    public void Rational_quarter_circle_keeps_its_radius_and_curvature()
    {
        var circle = new SplineCurve(new(2, [0, 0, 0, 1, 1, 1]), [new(5, 0, 0), new(5, 5, 0), new(0, 5, 0)], [1, Math.Sqrt(0.5), 1]);
        Span<Vector3> d = stackalloc Vector3[3];
        for (var i = 0; i <= 10; i++)
        {
            circle.Derivatives(i / 10.0, d);
            Assert.Equal(5, d[0].Length, 12);
            Assert.Equal(0.2, d[1].Cross(d[2]).Length / Math.Pow(d[1].Length, 3), 12);
        }
    }

    [Fact]
    public void Rational_cylinder_has_the_curvatures_of_a_cylinder()
    {
        var half = Math.Sqrt(0.5);
        var cylinder = new SplineSurface(
            new(2, [0, 0, 0, 1, 1, 1]),
            new(1, [0, 0, 1, 1]),
            [new(5, 0, 0), new(5, 0, 9), new(5, 5, 0), new(5, 5, 9), new(0, 5, 0), new(0, 5, 9)],
            [1, 1, half, half, 1, 1]);
        var at = cylinder.At(0.37, 0.6);
        Assert.Equal(5, Math.Sqrt((at.Position.X * at.Position.X) + (at.Position.Y * at.Position.Y)), 12);
        var (largest, smallest) = at.PrincipalCurvatures;
        Assert.Equal(0, largest, 12);
        Assert.Equal(-0.2, smallest, 12);
        Assert.Equal(at.Position.X / 5, at.Normal.X, 12);
    }

    [Fact]
    public void Second_derivatives_of_the_fast_way_are_those_of_the_general_one() =>
        Draw.Law(DrawSpline.Surface.Zip(Gen.Choose(-999, 999).Two()), c =>
    {
        var surface = c.Item1;
        var (u, v) = (DrawSpline.Inside(surface.KnotsU, c.Item2.Item1 / 1000.0), DrawSpline.Inside(surface.KnotsV, c.Item2.Item2 / 1000.0));
        var at = surface.At(u, v);
        var d = new Vector3[9];
        surface.Derivatives(u, v, 2, d);
        return Same(d[0], at.Position - default(Point3)) && Same(d[0], surface.PointAt(u, v) - default(Point3))
            && Same(d[3], at.Du) && Same(d[1], at.Dv) && Same(d[6], at.Duu) && Same(d[4], at.Duv) && Same(d[2], at.Dvv);

        static bool Same(Vector3 a, Vector3 b) => (a - b).Length < 1e-11 * (100 + a.Length);
    });

    [Fact]
    public void Weights_that_are_all_alike_say_nothing()
        => Assert.False(new SplineCurve(new(1, [0, 0, 1, 1]), [new(0, 0, 0), new(1, 0, 0)], [3, 3]).IsRational);

    [Theory]
    [InlineData(new double[] { 0, 0, 1 })]
    [InlineData(new double[] { 0, 1, 0, 1 })]
    [InlineData(new double[] { 0, 0, 0, 1 })]
    [InlineData(new double[] { 0, 0, 0, 0 })]
    public void Knots_that_no_spline_has_are_refused(double[] knots)
        => Assert.Equal(GeometryError.BadKnots, Assert.Throws<GeometryException>(() => new KnotVector(1, knots)).Error);

    private static void Near(Vector3 expected, Vector3 actual) => Assert.True((expected - actual).Length < 1e-12, $"{expected} {actual}");

    private static void Near(Point3 expected, Point3 actual) => Assert.True((expected - actual).Length < 1e-12, $"{expected} {actual}");
}
