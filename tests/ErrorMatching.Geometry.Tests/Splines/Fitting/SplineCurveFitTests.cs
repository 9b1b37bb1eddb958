using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

public sealed class SplineCurveFitTests
{
    [Fact]
    public void Interpolation_goes_through_every_point() => Draw.Law(
        Draw.Coordinate.Three().ListOf(12),
        all =>
        {
            Point3[] points = [.. all.Select(c => new Point3(c.Item1, c.Item2, c.Item3)).Distinct()];
            if (points.Length < 2)
            {
                return true;
            }

            var parameters = SplineParameters.ChordLength(points);
            var curve = SplineCurveFit.Interpolate(points, parameters);
            return points.Select((p, i) => (curve.PointAt(parameters[i]) - p).Length).Max() < 1e-8;
        },
        200);

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(5)]
    public void Interpolation_gives_polynomials_of_its_degree_back(int degree)
    {
        double[] t = [0, 0.1, 0.25, 0.3, 0.55, 0.7, 0.8, 1];
        var curve = SplineCurveFit.Interpolate([.. t.Select(s => Monomial(s, degree))], t, degree);
        Assert.Equal(degree, curve.Knots.Degree);
        Assert.All(Enumerable.Range(0, 101).Select(k => k / 100.0), s => Near(Monomial(s, degree), curve.PointAt(s), 1e-12));
    }

    [Fact]
    public void Cubic_interpolation_of_a_function_converges_with_the_fourth_order()
    {
        var (coarse, fine) = (ErrorOfSine(21), ErrorOfSine(41));
        Assert.InRange(Math.Log2(coarse / fine), 3.7, 4.3);
    }

    [Fact]
    public void Chord_lengths_are_shares_of_the_way()
    {
        Assert.Equal([0, 0.3, 1], SplineParameters.ChordLength([new(0, 0, 0), new(3, 0, 0), new(3, 7, 0)]));
        // Square roots of 4 and 9.
        Assert.Equal([0, 0.4, 1], SplineParameters.Centripetal([new(0, 0, 0), new(4, 0, 0), new(4, 0, 9)]));
    }

    [Fact]
    public void Knots_for_interpolation_are_means_of_parameters()
        // The example after equation 9.8 of The NURBS Book: parameters 0, 5/17, 9/17, 14/17, 1 and degree 3 give the inner knot 28/51.
        => Assert.Equal(28.0 / 51, FittingKnots.ForInterpolation(3, [0, 5.0 / 17, 9.0 / 17, 14.0 / 17, 1]).Values[4], 15);

    [Fact]
    public void Least_squares_of_a_constant_is_the_mean()
    {
        // Residuals of +-1 in turns about a straight line, four of each side symmetric:
        // the least-squares line of degree 1 without inner knots is y = 0.
        double[] t = [0, 1, 2, 3];
        var curve = SplineCurveFit.LeastSquares(
            [new(0, 1, 0), new(1, -1, 0), new(2, -1, 0), new(3, 1, 0)], t, KnotVector.Clamped(1, [0, 3]));
        Near(new(0, 0, 0), curve.PointAt(0), 1e-14);
        Near(new(3, 0, 0), curve.PointAt(3), 1e-14);
    }

    [Fact]
    public void Least_squares_residuals_are_perpendicular_to_every_basis_function()
    {
        var t = Enumerable.Range(0, 40).Select(k => k / 39.0).ToArray();
        var noise = Draw.Noise(7, 40);
        var knots = FittingKnots.ForLeastSquares(3, t, 9);
        var curve = SplineCurveFit.LeastSquares(
            [.. t.Select((s, i) => new Point3(s, Math.Sin(6 * s) + noise[i], noise[39 - i]))], t, knots);
        for (var pole = 0; pole < knots.PoleCount; pole++)
        {
            var poles = new Point3[knots.PoleCount];
            poles[pole] = new(1, 0, 0);
            var function = new SplineCurve(knots, poles);
            var sum = t.Select((s, i) => function.PointAt(s).X * (Math.Sin(6 * s) + noise[i] - curve.PointAt(s).Y)).Sum();
            Assert.Equal(0, sum, 12);
        }
    }

    [Fact]
    public void Points_that_leave_a_pole_open_are_refused()
    {
        var knots = KnotVector.Clamped(3, [0, 0.5, 1]);
        Assert.False(FittingKnots.Determine(knots, [0.6, 0.65, 0.7, 0.8, 0.9]));
        Assert.True(FittingKnots.Determine(knots, [0, 0.1, 0.7, 0.8, 1]));
        Refused.With(GeometryError.RankDeficient, () => SplineCurveFit.LeastSquares(new Point3[5], [0.6, 0.65, 0.7, 0.8, 0.9], knots));
    }

    [Fact]
    public void Family_of_curves_is_the_curves_one_by_one()
    {
        double[] t = [0, 0.2, 0.3, 0.6, 0.8, 1];
        var knots = FittingKnots.ForLeastSquares(2, t, 4);
        Point3[][] points = [
            .. Enumerable.Range(0, 3).Select(j => t.Select(s => new Point3(s, Math.Cos(s * (j + 1)), Math.Exp(s * j))).ToArray())];
        var family = SplineCurveFit.LeastSquaresFamily(points, t, knots);
        for (var j = 0; j < 3; j++)
        {
            Near(SplineCurveFit.LeastSquares(points[j], t, knots).PointAt(0.37), family[j].PointAt(0.37), 1e-13);
        }
    }

    [Fact]
    public void Smoothing_keeps_a_straight_line_whatever_its_weight()
    {
        var t = Enumerable.Range(0, 20).Select(k => k / 19.0).ToArray();
        var curve = SplineCurveFit.Smooth(
            [.. t.Select(s => new Point3(3 * s, 1 - (2 * s), 5 * s))], t, FittingKnots.ForInterpolation(3, t));
        Assert.All(t, s => Near(new(3 * s, 1 - (2 * s), 5 * s), curve.PointAt(s), 1e-10));
    }

    [Fact]
    public void Smoothing_takes_most_of_the_noise_away()
    {
        var t = Enumerable.Range(0, 100).Select(k => k / 99.0).ToArray();
        var noise = Draw.Noise(3, 100);
        var curve = SplineCurveFit.Smooth(
            [.. t.Select((s, i) => new Point3(s, Math.Sin(3 * s) + (0.1 * noise[i]), 0))], t, FittingKnots.ForLeastSquares(3, t, 40));
        var left = Math.Sqrt(t.Average(s => Math.Pow(curve.PointAt(s).Y - Math.Sin(3 * s), 2)));
        // The noise has a standard deviation of 0.1 / sqrt(3) = 0.058; a quadratic with its 3 coefficients would leave sqrt(3 / 100) of it,
        // an interpolation all.
        Assert.InRange(left, 0, 0.4 * 0.1 / Math.Sqrt(3));
    }

    [Fact]
    public void Points_that_determine_no_curve_are_refused()
    {
        Refused.With(GeometryError.TooFewPoints, () => SplineCurveFit.Interpolate([new(0, 0, 0)]));
        Refused.With(GeometryError.CoincidentPoints, () => SplineCurveFit.Interpolate([new(0, 0, 0), new(1, 0, 0), new(1, 0, 0)]));
        Refused.With(GeometryError.NotFinite, () => SplineCurveFit.Interpolate([new(0, 0, 0), new(double.NaN, 0, 0)]));
        Refused.With(GeometryError.BadKnots, () => SplineCurveFit.Interpolate([new(0, 0, 0), new(1, 0, 0)], [0, 0]));
        Refused.With(
            GeometryError.BadKnots, () => SplineCurveFit.Smooth([new(0, 0, 0), new(1, 0, 0)], [0, 1], KnotVector.Clamped(1, [0, 1])));
    }

    private static Point3 Monomial(double t, int degree) => new(t, Math.Pow(t, degree), 2 - (3 * Math.Pow(t, degree)) + t);

    private static double ErrorOfSine(int count)
    {
        var t = Enumerable.Range(0, count).Select(k => k / (count - 1.0)).ToArray();
        var curve = SplineCurveFit.Interpolate([.. t.Select(s => new Point3(s, Math.Sin(5 * s), 0))], t);
        // Inside, where the free ends have no say.
        return Enumerable.Range(300, 401).Max(k => Math.Abs(curve.PointAt(k / 1000.0).Y - Math.Sin(5 * k / 1000.0)));
    }

    private static void Near(Point3 expected, Point3 actual, double tolerance) =>
        Assert.True((expected - actual).Length <= tolerance, $"{expected} {actual}");
}
