using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Geometry;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The map is in the middle of the screen of free-form surfaces, with sections under the finger, the tool's path over it, and
/// the surface in space beside it.</summary>
public sealed class FreeformPictureTests
{
    private const double MostHead = 120;

    [Theory]
    [InlineData(Language.English)]
    [InlineData(Language.TraditionalChinese)]
    public Task The_map_has_half_of_the_content_and_all_of_it_at_one_tap(Language language) => Seat.AtAsync(seat =>
    {
        Arrive(seat);
        Texts.Current.Language = language;
        seat.User.Settle();
        Assert.Equal((1280, 800), (seat.Window.Width, seat.Window.Height));
        var content = Layout.In(seat.Window.GetVisualDescendants().OfType<ScreenHost>().First(h => h.IsEffectivelyVisible), seat.Window);
        var map = (SurfacePlot)seat.See("map");
        Assert.InRange(Layout.In(seat.See("surface-head").FindAncestorOfType<Border>()!, seat.Window).Height, 40, MostHead);
        Assert.InRange(Share(map), 0.5, 0.6);
        string[] others = ["surfaces", "surface-head", "freeform-approve", "tab-compare"];
        string[] keys = ["map-legend", "section-u", "section-v", "map-caption", "map-path"];
        seat.Tap("map-whole");
        Assert.True(map.FillsScreen);
        Assert.InRange(Share(map), 0.8, 1);
        Assert.All(others, id => Assert.Null(seat.Find(id)));
        Assert.All(keys, id => Assert.NotNull(seat.Find(id)));
        seat.Tap("map-whole");
        Assert.InRange(Share(map), 0.5, 0.6);
        Assert.All([.. others, .. keys], id => Assert.NotNull(seat.Find(id)));

        // The colors of what fills the screen stay, wherever there is a map.
        foreach (var (side, plot, legend) in new[] {
            ("tab-solid", "solid", "solid-legend"), ("tab-compare", "map-mirror", "compare-legend") })
        {
            seat.Tap(side).Tap(plot + "-whole");
            Assert.InRange(Share(seat.See(plot)), 0.8, 1);
            Assert.NotNull(seat.Find(legend));
            seat.Tap(plot + "-whole");
        }

        double Share(Control plot)
        {
            var place = Layout.Seen(plot, seat.Window);
            return place.Width * place.Height / (content.Width * content.Height);
        }
    });

    [Theory]
    [InlineData(Language.English)]
    [InlineData(Language.TraditionalChinese)]
    public Task The_sections_go_through_the_worst_place_or_through_the_one_that_is_tapped(Language language) => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        Texts.Current.Language = language;
        seat.WaitFor(() => Detail(seat).Language == language, "The details stay in the other language.");
        detail = Detail(seat);
        var (map, drawing) = ((SurfacePlot)seat.See("map"), detail.Figures.Measured);
        var (net, values) = (drawing.Net, drawing.ValuesMm!);
        var worst = values.Select(Math.Abs).Max();
        Assert.True(detail.Sections!.IsWorst);
        Assert.Equal(worst, Math.Abs(detail.Sections.ValueMm), 1e-12);
        Assert.Contains(
            Shown.SignedMicrometers(detail.Sections.ValueMm), ((MapSectionPlot)seat.See("section-u")).Caption, StringComparison.Ordinal);

        // A place of the net away from the points: the sections are the values of its two lines.
        var (i, j) = Enumerable.Range(1, net.CountU - 2)
            .SelectMany(u => Enumerable.Range(1, net.CountV - 2).Select(v => (u, v)))
            .MaxBy(p => drawing.Points.Min(q => q.At.DistanceTo(Above(p.u, p.v))));
        seat.User.Click(map, map.View.At(Above(i, j)));
        var sections = Detail(seat).Sections!;
        Assert.False(sections.IsWorst);
        Assert.InRange(sections.At.DistanceTo(Above(i, j)), 0, 1 / map.View.ScaleX);
        Assert.Same(sections, ((MapSectionPlot)seat.See("section-u")).Sections);
        Assert.Same(sections, map.Sections);
        var exact = SurfaceSections.Of(drawing, Above(i, j))!;
        Assert.Equal(values[(i * net.CountV) + j], exact.ValueMm, 1e-9);
        AssertValues([.. Enumerable.Range(0, net.CountU).Select(u => (Above(u, j), values[(u * net.CountV) + j]))], exact.AlongU);
        AssertValues([.. Enumerable.Range(0, net.CountV).Select(v => (Above(i, v), values[(i * net.CountV) + v]))], exact.AlongV);

        // What is said is what is drawn.
        Assert.Contains(
            Shown.SignedMicrometers(sections.ValueMm), ((MapSectionPlot)seat.See("section-u")).Caption, StringComparison.Ordinal);
        Assert.Contains(Shown.SignedMicrometers(sections.ValueMm), map.Values, StringComparison.Ordinal);

        // The keys lead from point to point, and the sections follow; a tap beside the surface shows the worst place again.
        map.Focus();
        seat.User.Press(Key.PageDown);
        Assert.Contains(drawing.Points, p => p.At == Detail(seat).Place);
        seat.User.Click(map, new(4, map.Bounds.Height / 2));
        Assert.True(Detail(seat).Sections!.IsWorst);

        Point2 Above(int u, int v) => net.Places[(u * net.CountV) + v] is var p ? new(p.X, p.Y) : default;
    });

    [Fact]
    public Task The_path_of_the_tool_is_laid_over_the_map_if_asked_for() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        var map = (SurfacePlot)seat.See("map");
        Assert.Null(map.Path);
        seat.Tap("map-path").WaitFor(() => map.Path is not null, $"The path does not come: {detail.PathTrouble}.");
        var count = detail.Stored.Surface!.ToolPath!.Passes;

        // With the links between them.
        Assert.InRange(map.Path!.Passes.Count, count, 2 * count);

        // The passes are those of the surface, and further out by no more than the tool.
        var (path, surface) = (PlotBox.Of(map.Path.Passes.SelectMany(p => p)), detail.Figures.Measured.Extent);
        Assert.InRange(path.Left, surface.Left - 10, surface.Left + 1);
        Assert.InRange(path.High, surface.High - 1, surface.High + 10);

        // They are closer together than the screen can show: one of several is drawn, and near enough all of them.
        var (passes, of) = map.Path.Thinned(map.View.ScaleX, DrawnSizes.PassesApart);
        Assert.InRange(of, 2, count / 10);
        Assert.InRange(passes.Count * of, count - of, count + of);
        var lines = passes.Select(p => map.View.At(p[0]).Y).Order().ToArray();
        Assert.All(
            lines.Zip(lines.Skip(1)),
            l => Assert.InRange(l.Second - l.First, DrawnSizes.PassesApart - 1, 3 * DrawnSizes.PassesApart));
        Assert.Equal((map.Path.Passes, 1), map.Path.Thinned(100 * map.View.ScaleX, DrawnSizes.PassesApart));
        seat.User.Screenshot(Repository.PathTo("artifacts", "screenshots", "freeform-path.png"));

        // It stays over the next surface, and in another language.
        Texts.Current.Language = Language.TraditionalChinese;
        seat.WaitFor(() => map.Path is not null && Detail(seat) != detail, "The path is gone in the other language.");
        seat.Tap("map-path");
        Assert.Null(map.Path);
    });

    [Fact]
    public Task The_surface_in_space_turns_with_fingers_and_keys() => Seat.AtAsync(seat =>
    {
        Arrive(seat);
        seat.Tap("tab-solid");
        var solid = (SolidPlot)seat.See("solid");
        Assert.Equal(SurfaceTurn.Default, solid.Turn);
        var view = solid.View;
        var middle = new Point(solid.Bounds.Width / 2, solid.Bounds.Height / 2);
        seat.User.Drag(solid, middle, middle + new Point(100, 0));
        Assert.InRange(solid.Turn.YawDegrees, 5, 15);
        Assert.Equal(SurfaceTurn.Default.PitchDegrees, solid.Turn.PitchDegrees);
        Assert.Equal(view, solid.View);
        seat.User.Press(Key.Down);
        Assert.True(solid.Turn.PitchDegrees > SurfaceTurn.Default.PitchDegrees);
        seat.Tap("solid-nearer");
        Assert.True(solid.View.ScaleX > view.ScaleX);
        seat.User.Screenshot(Repository.PathTo("artifacts", "screenshots", "freeform-solid-turned.png"));
        solid.Focus();
        seat.User.Press(Key.D0);
        Assert.Equal((SurfaceTurn.Default, view), (solid.Turn, solid.View));
        seat.User.Press(Key.PageDown);
        Assert.Equal(Detail(seat).Figures.Measured.Points[0].Values, solid.Values);
        seat.User.Pinch(
            solid, (middle - new Point(40, 0), middle - new Point(120, 0)), (middle + new Point(40, 0), middle + new Point(120, 0)));
        Assert.InRange(solid.View.ScaleX / view.ScaleX, 2, 4);
    });

    private static void AssertValues((Point2 At, double Mm)[] expected, MapSection section)
    {
        Assert.Equal(expected.Length, section.Points.Count);
        Assert.All(
            expected.Zip(section.Points),
            p =>
            {
                Assert.Equal(p.First.Mm, p.Second.ValueMm, 1e-9);
                Assert.InRange(p.First.At.DistanceTo(p.Second.Above), 0, 1e-6);
            });
    }

    private static SurfaceDetail Arrive(Seat seat)
    {
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-freeform").See("map");
        return Detail(seat);
    }

    private static SurfaceDetail Detail(Seat seat) => ((FreeformViewModel)seat.Shell.Current!).Detail!;
}
