namespace ErrorMatching.Geometry.Tests;

public sealed class SplineSurfaceFitTests
{
    private static readonly double[] Us = [0, 0.12, 0.3, 0.45, 0.5, 0.77, 0.9, 1];
    private static readonly double[] Vs = [0, 0.2, 0.35, 0.6, 0.8, 1];

    [Fact]
    public void Interpolation_goes_through_every_point_and_gives_bicubics_back()
    {
        var surface = SplineSurfaceFit.Interpolate(Grid(Bicubic, Us, Vs), Us, Vs);
        Assert.Equal((3, 3, 8, 6), (surface.KnotsU.Degree, surface.KnotsV.Degree, surface.CountU, surface.CountV));
        AssertEverywhere(Bicubic, surface, 1e-12);
    }

    [Fact]
    public void A_sphere_that_is_no_height_field_is_interpolated()
    {
        // Three quarters around: x, y and z are all folded over each other.
        static Point3 Ball(double u, double v)
        {
            var (a, b) = (1.5 * Math.PI * u, (v - 0.5) * 2);
            return new(20 * Math.Cos(a) * Math.Cos(b), 20 * Math.Sin(a) * Math.Cos(b), 20 * Math.Sin(b));
        }

        var (us, vs) = (Even(41), Even(21));
        var surface = SplineSurfaceFit.Interpolate(Grid(Ball, us, vs), 41, 21);
        foreach (var u in Even(60))
        {
            foreach (var v in Even(30))
            {
                var p = surface.PointAt(u, v);
                // 4th order: steps of 0.12 and 0.1 rad leave some 20 * 0.12^4 / 384 = 1e-5, more beside the ends.
                Assert.Equal(20, Math.Sqrt((p.X * p.X) + (p.Y * p.Y) + (p.Z * p.Z)), 2e-4);
            }
        }
    }

    [Fact]
    public void Fewer_points_than_the_degree_lower_it()
    {
        var surface = SplineSurfaceFit.Interpolate(
            [new(0, 0, 0), new(0, 9, 1), new(5, 0, 2), new(5, 9, 3), new(8, 0, 1), new(8, 9, 0)], 3, 2);
        Assert.Equal((2, 1), (surface.KnotsU.Degree, surface.KnotsV.Degree));
    }

    [Fact]
    public void Least_squares_on_a_grid_and_of_scattered_points_are_one()
    {
        var noise = Draw.Noise(5, Us.Length * Vs.Length);
        var grid = Grid(Bicubic, Us, Vs).Select((p, k) => p + new Vector3(0, 0, noise[k])).ToArray();
        var (knotsU, knotsV) = (FittingKnots.ForLeastSquares(3, Us, 5), FittingKnots.ForLeastSquares(2, Vs, 4));
        var tensor = SplineSurfaceFit.LeastSquares(grid, Us, Vs, knotsU, knotsV);
        // The same points backwards, each with parameters of its own.
        var us = Enumerable.Range(0, grid.Length).Select(k => Us[k / Vs.Length]).Reverse().ToArray();
        var vs = Enumerable.Range(0, grid.Length).Select(k => Vs[k % Vs.Length]).Reverse().ToArray();
        var scattered = SplineSurfaceFit.LeastSquaresScattered([.. grid.Reverse()], us, vs, knotsU, knotsV);
        for (var k = 0; k < tensor.Poles.Length; k++)
        {
            Near(tensor.Poles[k], scattered.Poles[k], 1e-11);
        }
    }

    [Fact]
    public void Smoothing_keeps_a_plane_and_its_weight_makes_it_stiffer()
    {
        var (us, vs) = (Even(8), Even(7));
        var noise = Draw.Noise(2, 56);
        var grid = Grid((u, v) => new(10 * u, 7 * v, u - (2 * v)), us, vs);
        var (knotsU, knotsV) = (FittingKnots.ForInterpolation(3, us), FittingKnots.ForInterpolation(3, vs));
        var (allU, allV) = (Scattered(us, vs, true), Scattered(us, vs, false));
        var plane = SplineSurfaceFit.Smooth(grid, allU, allV, knotsU, knotsV, 10, 7);
        AssertEverywhere((u, v) => new(10 * u, 7 * v, u - (2 * v)), plane.Surface, 1e-9);

        var rough = grid.Select((p, k) => p + new Vector3(0, 0, noise[k])).ToArray();
        var limp = SplineSurfaceFit.Smooth(rough, allU, allV, knotsU, knotsV, 10, 7, 1e-9);
        var stiff = SplineSurfaceFit.Smooth(rough, allU, allV, knotsU, knotsV, 10, 7, 1e9);
        // Without weight every pole counts; with a great one only the three coefficients of a plane are left.
        Assert.Equal(56, limp.EffectiveParameters, 1e-3);
        Assert.Equal(3, stiff.EffectiveParameters, 1e-3);
        var free = SplineSurfaceFit.Smooth(rough, allU, allV, knotsU, knotsV, 10, 7);
        Assert.InRange(free.EffectiveParameters, 3, 56);
        Assert.Equal(
            free.Surface.Poles.ToArray(),
            SplineSurfaceFit.Smooth(rough, allU, allV, knotsU, knotsV, 10, 7, free.Weight).Surface.Poles.ToArray());
    }

    [Fact]
    public void Weight_of_smoothing_takes_most_of_the_noise_of_a_flat_wave_away()
    {
        var (us, vs) = (Even(20), Even(20));
        var noise = Draw.Noise(11, 400);
        static Point3 Wave(double u, double v) => new(40 * u, 40 * v, 0.02 * Math.Sin(3 * u) * Math.Cos(2 * v));
        var rough = Grid(Wave, us, vs).Select((p, k) => p + new Vector3(0, 0, 0.01 * noise[k])).ToArray();
        var knots = FittingKnots.ForLeastSquares(3, us, 12);
        var fit = SplineSurfaceFit.Smooth(rough, Scattered(us, vs, true), Scattered(us, vs, false), knots, knots, 40, 40);
        var left = Math.Sqrt(
            Even(37).SelectMany(u => Even(37).Select(v => Math.Pow(fit.Surface.PointAt(u, v).Z - Wave(u, v).Z, 2))).Average());
        // 0.0058 of noise; ten coefficients of a cubic would leave sqrt(10 / 400) of it.
        Assert.InRange(left, 0, 0.35 * 0.01 / Math.Sqrt(3));
    }

    [Fact]
    public void Skin_runs_through_its_sections_of_different_degrees_and_knots()
    {
        double[] vs = [0, 0.3, 0.6, 1];
        var curves = vs.Select((v, j) => SplineCurveFit.Interpolate(
            [.. Even(4 + j).Select(u => new Point3(10 * u, 8 * v, Math.Sin((3 * u) + v)))], Even(4 + j), 1 + (j % 3))).ToArray();
        var surface = SplineSurfaceFit.Skin(curves, vs);
        for (var j = 0; j < vs.Length; j++)
        {
            Assert.All(Even(33), u => Near(curves[j].PointAt(u), surface.PointAt(u, vs[j]), 1e-12));
        }
    }

    [Fact]
    public void Gordon_surface_runs_through_both_families_of_curves()
    {
        double[] us = [0, 0.4, 0.7, 1], vs = [0, 0.5, 1];
        static Point3 Wavy(double u, double v) => new(10 * u, 9 * v, Math.Sin(4 * u) + (Math.Cos(5 * v) * u));
        // Curves of one family cross those of the other exactly at its interpolated points.
        var alongU = vs.Select(v => SplineCurveFit.Interpolate(
            [.. Even(11).Concat(us).Distinct().Order().Select(u => Wavy(u, v))], [.. Even(11).Concat(us).Distinct().Order()])).ToArray();
        var alongV = us.Select(u => SplineCurveFit.Interpolate([.. Even(9).Select(v => Wavy(u, v))], Even(9))).ToArray();
        var surface = SplineSurfaceFit.Gordon(alongU, vs, alongV, us, 1e-9);
        for (var j = 0; j < vs.Length; j++)
        {
            Assert.All(Even(41), u => Near(alongU[j].PointAt(u), surface.PointAt(u, vs[j]), 1e-11));
        }

        for (var i = 0; i < us.Length; i++)
        {
            Assert.All(Even(41), v => Near(alongV[i].PointAt(v), surface.PointAt(us[i], v), 1e-11));
        }
    }

    [Fact]
    public void Curves_that_do_not_meet_are_no_mesh()
    {
        static SplineCurve Line(Point3 a, Point3 b) => new(KnotVector.Clamped(1, [0, 1]), [a, b]);
        SplineCurve[] alongU = [Line(new(0, 0, 0), new(5, 0, 0)), Line(new(0, 4, 0), new(5, 4, 0))];
        SplineCurve[] alongV = [Line(new(0, 0, 0), new(0, 4, 0)), Line(new(5, 0, 0.2), new(5, 4, 0))];
        var refusal = Refused.With(GeometryError.OpenMesh, () => SplineSurfaceFit.Gordon(alongU, [0, 1], alongV, [0, 1], 0.1));
        Assert.Contains("curve 1 along u and curve 2 along v pass each other 0.2 mm apart", refusal.Message, StringComparison.Ordinal);
        // Within the gap the surface passes in the middle.
        Near(new(5, 0, 0.1), SplineSurfaceFit.Gordon(alongU, [0, 1], alongV, [0, 1], 0.3).PointAt(1, 0), 1e-12);
    }

    [Fact]
    public void Points_on_a_grid_are_those_one_by_one()
    {
        var half = Math.Sqrt(0.5);
        var cylinder = new SplineSurface(
            new(2, [0, 0, 0, 1, 1, 1]),
            new(1, [0, 0, 1, 1]),
            [new(5, 0, 0), new(5, 0, 9), new(5, 5, 0), new(5, 5, 9), new(0, 5, 0), new(0, 5, 9)],
            [1, 1, half, half, 1, 1]);
        var all = cylinder.PointsAt(Us, Vs);
        for (var k = 0; k < all.Length; k++)
        {
            Near(cylinder.PointAt(Us[k / Vs.Length], Vs[k % Vs.Length]), all[k], 1e-14);
        }
    }

    [Fact]
    public void Points_that_determine_no_surface_are_refused()
    {
        Refused.With(GeometryError.BadPoles, () => SplineSurfaceFit.Interpolate(new Point3[5], 2, 3));
        Refused.With(GeometryError.CoincidentPoints, () => SplineSurfaceFit.Interpolate(new Point3[6], 2, 3));
        Refused.With(GeometryError.TooFewPoints, () => SplineSurfaceFit.Skin([SplineCurveFit.Interpolate([new(0, 0, 0), new(1, 0, 0)])]));
        var line = KnotVector.Clamped(3, [0, 1]);
        // All on one line of the parameters: the bending of a plane about it costs nothing.
        Refused.With(
            GeometryError.RankDeficient,
            () => SplineSurfaceFit.Smooth([new(0, 0, 0), new(1, 0, 0), new(2, 0, 0)], [0, 0.5, 1], [0.5, 0.5, 0.5], line, line, 2, 2));
    }

    private static double[] Even(int count) => [.. Enumerable.Range(0, count).Select(k => k / (count - 1.0))];

    private static Point3[] Grid(Func<double, double, Point3> surface, double[] us, double[] vs) =>
        [.. us.SelectMany(u => vs.Select(v => surface(u, v)))];

    private static double[] Scattered(double[] us, double[] vs, bool isU) => [.. us.SelectMany(u => vs.Select(v => isU ? u : v))];

    private static Point3 Bicubic(double u, double v) => new(
        10 * u,
        (8 * v) + (u * v),
        (3 * u * u * u * v) - (2 * u * v * v * v) + (u * u) - 1);

    private static void AssertEverywhere(Func<double, double, Point3> expected, SplineSurface surface, double tolerance)
    {
        foreach (var u in Even(21))
        {
            foreach (var v in Even(21))
            {
                Near(expected(u, v), surface.PointAt(u, v), tolerance);
            }
        }
    }

    private static void Near(Point3 expected, Point3 actual, double tolerance) =>
        Assert.True((expected - actual).Length <= tolerance, $"{expected} {actual}");
}
