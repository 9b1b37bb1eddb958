namespace ErrorMatching.Geometry.Tests;

public sealed class SplineApproximationTests
{
    private static readonly KnotVector U = KnotVector.Clamped(3, [0, 75]);
    private static readonly KnotVector V = KnotVector.Clamped(3, [0, 63]);

    [Fact]
    public void Polynomial_of_the_degree_needs_no_knots()
    {
        var found = SplineApproximation.Fit((u, v) => new(u, v, (1e-4 * u * u * v) - (0.01 * v * v) + (1e-5 * u * u * u)), U, V, 1e-9);
        Assert.Equal((4, 4), (found.Surface.CountU, found.Surface.CountV));
        Assert.InRange(found.ErrorMm, 0, 1e-11);
    }

    [Fact]
    public void Offset_of_waves_is_met_within_the_tolerance_everywhere()
    {
        var waves = Shapes.Waves();
        Point3 Offset(double u, double v)
        {
            var at = waves.At(u, v);
            return at.Position + (at.Normal * 5);
        }

        // Normals are once less smooth than the surface, so its knots count twice.
        var found = SplineApproximation.Fit(
            Offset, KnotVector.Clamped(3, [.. waves.KnotsU.Breaks], 2), KnotVector.Clamped(3, [.. waves.KnotsV.Breaks], 2), 1e-4);
        var worst = 0.0;
        for (var i = 0; i <= 150; i++)
        {
            for (var j = 0; j <= 150; j++)
            {
                var (u, v) = (75 * i / 150.0, 63 * j / 150.0);
                worst = Math.Max(worst, (Offset(u, v) - found.Surface.PointAt(u, v)).Length);
            }
        }

        Assert.InRange(found.ErrorMm, 1e-9, 1e-4);
        Assert.InRange(found.Surface.CountU, 18, 40);
        Assert.InRange(worst, 0.2 * found.ErrorMm, 1.5 * found.ErrorMm);
    }

    [Fact]
    public void Knots_come_only_where_they_are_needed()
    {
        // A step of 1 mm width in x, nothing along y.
        var found = SplineApproximation.Fit((u, v) => new(u, v, 0.1 * Math.Tanh(u - 20)), U, V, 1e-5);
        Assert.Equal(4, found.Surface.CountV);
        var spans = found.Surface.KnotsU.Breaks;
        Assert.True(spans.Count(b => b is > 10 and < 30) > 3 * spans.Count(b => b is > 45 and < 65), string.Join(' ', spans));
    }

    [Fact]
    public void Kink_that_is_named_is_met_and_one_that_is_not_says_its_error()
    {
        static Point3 Roof(double u, double v) => new(u, v, 0.5 * Math.Abs(u - 30.1));
        var named = SplineApproximation.Fit(Roof, KnotVector.Clamped(3, [0, 30.1, 75], 3), V, 1e-6);
        Assert.InRange(named.ErrorMm, 0, 1e-12);
        Assert.Equal(7, named.Surface.CountU);
        var unnamed = SplineApproximation.Fit(Roof, U, V, 1e-6);
        Assert.True(unnamed.ErrorMm > 1e-6);
    }

    [Fact]
    public void Points_at_the_Greville_parameters_are_met()
    {
        var (u, v) = (KnotVector.Clamped(4, [0, 1, 1.5, 4], 2), KnotVector.Clamped(2, [0, 2, 3]));
        var noise = Draw.Noise(3, u.PoleCount * v.PoleCount * 3);
        var points = Enumerable.Range(0, u.PoleCount * v.PoleCount)
            .Select(i => new Point3(noise[3 * i], noise[(3 * i) + 1], noise[(3 * i) + 2]))
            .ToArray();
        var surface = SplineSurface.AtGreville(u, v, points);
        for (var i = 0; i < points.Length; i++)
        {
            Assert.True((surface.PointAt(u.Greville(i / v.PoleCount), v.Greville(i % v.PoleCount)) - points[i]).Length < 1e-13);
        }
    }

    [Fact]
    public void What_cannot_be_approximated_is_refused()
    {
        Refused.With(GeometryError.NotFinite, () => SplineApproximation.Fit((u, v) => new(u, v, 1 / (u - 75)), U, V, 1e-6));
        Refused.With(GeometryError.NotFinite, () => SplineApproximation.Fit((u, v) => new(u, v, 0), U, V, 0));
        Refused.With(GeometryError.BadKnots, () => SplineApproximation.Fit((u, v) => new(u, v, 0), new(1, [0, 0, 1, 1, 2, 2]), V, 1e-6));
    }
}
