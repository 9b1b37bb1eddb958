using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class BestSurfaceTests
{
    public static TheoryData<int> Quadratics => [.. Enumerable.Range(0, TrueShape.Quadratics.Length)];

    public static TheoryData<int> Breaks => [.. Enumerable.Range(0, TrueShape.Breaks.Length)];

    public static TheoryData<int> Waves => [.. Enumerable.Range(0, TrueShape.Waves.Length)];

    [Theory]
    [MemberData(nameof(Quadratics))]
    public void Quadratics_are_met_to_a_hundredth_of_a_micrometer(int number)
    {
        var shape = TrueShape.Quadratics[number];
        var fit = BestSurface.Fit(shape.Grid());

        Assert.InRange(shape.DistanceUm(fit.Surface).Mean, 0, 0.01);
        Assert.Empty(fit.BreaksU);
        Assert.Empty(fit.BreaksV);
        Assert.Equal(FitMethod.Best, fit.Method);
        Assert.InRange(fit.Surface.CountU, 2, 3);
        Assert.InRange(fit.Surface.CountV, 2, 3);
    }

    [Theory]
    [MemberData(nameof(Breaks))]
    public void Breaks_of_the_curvature_inside_cells_are_met_to_a_twentieth_of_a_micrometer(int number)
    {
        var shape = TrueShape.Breaks[number];
        var fit = BestSurface.Fit(shape.Grid());

        Assert.InRange(shape.DistanceUm(fit.Surface).Mean, 0, 0.05);
        Assert.InRange(1000 * fit.LeaveLineOutMm, 0, 0.05);
    }

    [Fact]
    public void Places_of_breaks_are_found()
    {
        var two = BestSurface.Fit(TrueShape.Breaks[4].Grid());
        Assert.Equal(2, two.BreaksU.Count);
        Assert.Equal(25, two.BreaksU[0], 1e-6);
        Assert.Equal(52, two.BreaksU[1], 1e-6);
        Assert.Empty(two.BreaksV);
        var crossing = BestSurface.Fit(TrueShape.Breaks[5].Grid());
        Assert.Equal(33, Assert.Single(crossing.BreaksU), 1e-6);
        Assert.Equal(26, Assert.Single(crossing.BreaksV), 1e-6);
    }

    [Fact]
    public void A_break_is_a_knot_at_which_the_slope_goes_on_and_the_curvature_jumps()
    {
        var surface = BestSurface.Fit(TrueShape.Breaks[0].Grid()).Surface;
        var knot = surface.KnotsU.Breaks[1];
        var (before, behind) = (surface.At(knot - 1e-7, 30), surface.At(knot + 1e-7, 30));

        Assert.Equal(40.3, knot, 1e-6);
        Assert.Equal(0, (behind.Du - before.Du).Length, 1e-7);
        Assert.Equal(2 * 0.012, (behind.Duu - before.Duu).Z, 1e-6);
    }

    [Theory]
    [MemberData(nameof(Waves))]
    public void Smooth_waves_are_met_to_a_twentieth_of_a_micrometer(int number)
    {
        var shape = TrueShape.Waves[number];

        Assert.InRange(shape.DistanceUm(BestSurface.Fit(shape.Grid()).Surface).Mean, 0, 0.05);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_break_among_waves_is_found(bool ragged)
    {
        var shape = new TrueShape("both", (x, y) => TrueShape.Breaks[0].Height(x, y) + TrueShape.Waves[1].Height(x, y));
        var fit = BestSurface.Fit(shape.Grid(ragged: ragged));

        Assert.Equal(40.3, Assert.Single(fit.BreaksU), 0.01);
        Assert.InRange(shape.DistanceUm(fit.Surface).Mean, 0, 0.1);
    }

    // A cubic spline through the points leaves 35 um in the mean.
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void Waves_of_three_points_a_period_are_met(double phase)
    {
        var shape = new TrueShape(
            "short", (x, y) => 0.3 * Math.Sin((2 * Math.PI * x / 25) + phase) * Math.Sin((2 * Math.PI * y / 31.5) + (2 * phase) + 1));
        var fit = BestSurface.Fit(shape.Grid());

        Assert.InRange(shape.DistanceUm(fit.Surface).Mean, 0, 0.05);
        Assert.Equal(0, fit.MissedMm);
        Assert.InRange(shape.DistanceUm(BestSurface.Fit(shape.Grid(noise: 0.001)).Surface).Mean, 0.1, 0.6);
    }

    [Fact]
    public void What_no_smooth_surface_describes_is_followed_point_by_point_and_told()
    {
        var step = new TrueShape("step", (x, y) => 0.3 * Math.Tanh((x - 31.843) / 3) * (0.284 + (y / 63)));
        var fit = SurfaceFitter.Fit(step.Grid(), FitMethod.Best, 0.001);
        var tensor = SurfaceFitter.Fit(step.Grid(), FitMethod.Tensor, 0.001);

        Assert.True(fit.IsThroughPoints);
        Assert.InRange(1000 * fit.MissedMm, 5, 100);
        Assert.All(step.Grid().Points, p => Assert.InRange(fit.Surface.ClosestPoint(p.Position).Distance, 0, 1e-5));
        Assert.InRange(step.DistanceUm(fit.Surface).Mean, 1, 1.02 * step.DistanceUm(tensor.Surface).Mean);
    }

    [Fact]
    public void Quadratics_with_noise_of_a_micrometer_come_out_within_a_third_of_it() =>
        Assert.InRange(NoisyUm(TrueShape.Quadratics), 0.1, 0.35);

    [Fact]
    public void Waves_with_noise_of_a_micrometer_come_out_within_six_tenths_of_it() => Assert.InRange(NoisyUm(TrueShape.Waves), 0.1, 0.6);

    [Fact]
    public void Breaks_with_noise_of_a_micrometer_are_still_found() => Assert.InRange(NoisyUm(TrueShape.Breaks), 0.1, 0.35);

    [Fact]
    public void Ragged_grids_are_met_like_rectangular_ones()
    {
        foreach (var shape in TrueShape.Quadratics.Concat(TrueShape.Breaks))
        {
            Assert.InRange(shape.DistanceUm(BestSurface.Fit(shape.Grid(ragged: true)).Surface).Mean, 0, 0.05);
        }
    }

    [Fact]
    public void A_part_turned_in_its_plane_is_met_as_well()
    {
        static Point3 Turn(Point3 p) =>
            new((Math.Cos(0.5) * p.X) - (Math.Sin(0.5) * p.Y) + 100, (Math.Sin(0.5) * p.X) + (Math.Cos(0.5) * p.Y) - 50, p.Z);
        foreach (var shape in TrueShape.Quadratics.Concat(TrueShape.Breaks))
        {
            Assert.InRange(shape.DistanceUm(BestSurface.Fit(shape.Grid(map: Turn)).Surface, Turn).Mean, 0, 0.05);
        }
    }

    [Fact]
    public void Height_over_another_coordinate_plane_is_height_as_well()
    {
        static Point3 Stand(Point3 p) => new(p.Z, p.X, p.Y);
        var shape = TrueShape.Quadratics[2];

        Assert.InRange(shape.DistanceUm(BestSurface.Fit(shape.Grid(map: Stand)).Surface, Stand).Mean, 0, 0.01);
    }

    [Fact]
    public void A_half_cylinder_is_no_height_and_is_met_over_its_chords()
    {
        var curves = Enumerable.Range(0, 7)
            .Select(j => (IReadOnlyList<GridPoint>)[.. Enumerable.Range(0, 13).Select(i => new GridPoint(i, j, On(i / 12.0, 9.0 * j)))])
            .ToArray();
        var distance = new SurfaceDistance(BestSurface.Fit(new(curves)).Surface);
        var worst = Enumerable.Range(0, 101).Max(k => 1000 * Math.Abs(distance.To(On(k / 100.0, 31))));

        Assert.InRange(worst, 0, 0.1);

        static Point3 On(double t, double y) =>
            new(-30 * Math.Cos(Math.PI * 1.2 * (t - 0.08)), y, 30 * Math.Sin(Math.PI * 1.2 * (t - 0.08)));
    }

    [Fact]
    public void Four_points_make_a_bilinear_surface()
    {
        var shape = new TrueShape("twisted", (x, y) => 1 + (0.01 * x) + (0.001 * x * y));
        var fit = BestSurface.Fit(shape.Grid(2, 2));

        Assert.True(double.IsNaN(fit.LeaveLineOutMm));
        Assert.Equal(4, fit.Surface.Poles.Length);
    }

    [Fact]
    public void The_same_points_give_the_same_surface()
    {
        var grid = TrueShape.Waves[1].Grid(noise: 0.001, seed: 3);

        Assert.Equal(BestSurface.Fit(grid).Surface.Poles.ToArray(), BestSurface.Fit(grid).Surface.Poles.ToArray());
    }

    [Fact]
    public void Grids_that_are_no_surface_are_refused()
    {
        var line = new PointGrid([[new(0, 0, new(0, 0, 0)), new(1, 0, new(1, 0, 0))]]);
        Assert.Equal("too-few-points", Assert.Throws<InputException>(() => BestSurface.Fit(line)).Code);
        var infinite = new PointGrid(
            [[new(0, 0, new(0, 0, 0)), new(1, 0, new(1, 0, 0))], [new(0, 1, new(0, 1, 0)), new(1, 1, new(1, 1, double.NaN))]]);
        var refused = Assert.Throws<InputException>(() => BestSurface.Fit(infinite));
        Assert.Equal("not-finite", refused.Code);
        Assert.Contains("i = 1, j = 1", refused.Message, StringComparison.Ordinal);
    }

    /// <summary>Mean over shapes and ten seeds.</summary>
    private static double NoisyUm(IReadOnlyCollection<TrueShape> shapes) =>
        shapes.Average(
            shape => Enumerable.Range(1, 10).Average(
                seed => shape.DistanceUm(BestSurface.Fit(shape.Grid(noise: 0.001, seed: seed)).Surface).Mean));
}
