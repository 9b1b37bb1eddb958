using ErrorMatching.Geometry;
using FsCheck.Fluent;

namespace ErrorMatching.Hmi.Tests;

public sealed class PlotThinningTests
{
    private const double Small = 1e-9;

    [Fact]
    public void In_each_column_the_lowest_and_the_highest_point_are_kept() => Law.Holds(Gen.NonEmptyListOf(Law.Point), line =>
    {
        // All of the line is seen, a unit a column.
        var view = new PlotView(1, 1, new(0, 0), 400, 400);
        var thin = PlotThinning.Of([.. line], view)
            .GroupBy(p => Math.Floor(p.At.X))
            .ToDictionary(g => g.Key, g => (g.Min(p => p.At.Y), g.Max(p => p.At.Y)));
        return line.Distinct().Count() == 1
            || line.Select(view.ToScreen).GroupBy(p => Math.Floor(p.X)).All(g => thin[g.Key] == (g.Min(p => p.Y), g.Max(p => p.Y)));
    });

    [Fact]
    public void A_hundred_thousand_points_become_four_a_column()
    {
        Point2[] noise = [.. Enumerable.Range(0, 100_000).Select(i => new Point2(i, Math.Sin(i * i)))];
        var thin = PlotThinning.Of(noise, PlotView.Fit(PlotBox.Of(noise), 1000, 500, 0, isTrue: false));
        Assert.InRange(thin.Count, 1000, 4004);
        Assert.Single(thin, p => p.Begins);
    }

    [Fact]
    public void What_leaves_the_view_is_cut_off_near_its_border_and_goes_on_where_it_returns()
    {
        var view = new PlotView(1, 1, new(50, 50), 100, 100);
        var thin = PlotThinning.Of([new(50, 50), new(1050, 50), new(1050, 1000), new(50, 1000), new(50, 60)], view);
        Assert.Equal([true, false, true, false], thin.Select(p => p.Begins));
        Assert.Equal([new(50, 50), new(116, 50), new(50, -16), new(50, 40)], thin.Select(p => p.At), (a, b) => a.DistanceTo(b) < Small);
    }

    [Fact]
    public void What_is_no_number_interrupts_the_line() => Assert.Equal(
        [true, false, true, false],
        PlotThinning.Of(
            [new(0, 0), new(5, 0), new(double.NaN, 0), new(10, 0), new(15, 0)], new(1, 1, new(0, 0), 100, 100)).Select(p => p.Begins));
}
