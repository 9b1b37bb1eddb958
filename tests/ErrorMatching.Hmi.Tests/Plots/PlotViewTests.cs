using ErrorMatching.Geometry;
using FsCheck.Fluent;

namespace ErrorMatching.Hmi.Tests;

public sealed class PlotViewTests
{
    private const double Small = 1e-6;

    [Fact]
    public void The_screen_and_back_is_the_same_place() =>
        Law.Holds(Law.View.Zip(Law.Point), p => p.Item1.ToPlot(p.Item1.ToScreen(p.Item2)).DistanceTo(p.Item2) < Small);

    [Fact]
    public void Zooming_about_a_point_keeps_what_is_under_it() => Law.Holds(Law.View.Zip(Law.Point).Zip(Gen.Choose(1, 100)), p =>
    {
        var ((view, about), tenths) = p;
        var zoomed = view.Zoom(tenths / 10.0, about);
        return zoomed.ToPlot(about).DistanceTo(view.ToPlot(about)) < Small
            && Math.Abs((zoomed.ScaleX / view.ScaleX) - (tenths / 10.0)) < Small;
    });

    [Fact]
    public void Panning_moves_what_is_seen_with_the_finger() => Law.Holds(Law.View.Zip(Law.Point).Zip(Law.Point), p =>
    {
        var ((view, place), by) = p;
        var (was, now) = (view.ToScreen(place), view.Pan(by - Point2.Origin).ToScreen(place));
        return (now - was - (by - Point2.Origin)).Length < Small;
    });

    [Fact]
    public void Fitting_shows_everything_inside_of_the_room_around_it() =>
        Law.Holds(Gen.NonEmptyListOf(Law.Point).Zip(Gen.Elements(true, false)), p =>
    {
        var (points, isTrue) = p;
        var view = PlotView.Fit(PlotBox.Of(points), 800, 600, 30, isTrue);
        return points.Select(view.ToScreen).All(s => s.X >= 30 - Small && s.X <= 770 + Small && s.Y >= 30 - Small && s.Y <= 570 + Small)
            && (!isTrue || view.ScaleX == view.ScaleY);
    });

    [Fact]
    public void Fitting_fills_at_least_one_direction() => Law.Holds(Gen.ListOf(Law.Point).Where(l => l.Distinct().Count() > 1), points =>
    {
        var screen = points.Select(PlotView.Fit(PlotBox.Of(points), 800, 600, 30, isTrue: true).ToScreen).ToArray();
        return Math.Abs(screen.Max(s => s.X) - screen.Min(s => s.X) - 740) < Small
            || Math.Abs(screen.Max(s => s.Y) - screen.Min(s => s.Y) - 540) < Small;
    });

    [Fact]
    public void What_is_seen_is_what_the_corners_show()
    {
        var view = new PlotView(2, 4, new(10, 20), 100, 80);
        Assert.Equal(new PlotBox(-15, 10, 35, 30), view.Seen);
        Assert.Equal(new Point2(-15, 30), view.ToPlot(new(0, 0)));
    }

    [Fact]
    public void A_single_place_and_none_can_be_shown()
    {
        Assert.Equal(new Point2(400, 300), PlotView.Fit(PlotBox.Of([new(5, 7)]), 800, 600, 30, isTrue: true).ToScreen(new(5, 7)));
        Assert.True(PlotView.Fit(PlotBox.Empty, 800, 600, 30, isTrue: false).ToScreen(new(0, 0)).IsFinite);
        Assert.True(PlotBox.Of([new(double.NaN, 1)]).IsEmpty);
    }
}
