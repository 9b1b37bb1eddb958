using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What a pointer, fingers and keys do to a plot. The gap is drawn between two lines from (0, 0) to (100,
/// 0) and 1 above.</summary>
public sealed class PlotAreaTests
{
    private const double Small = 1e-6;

    [Fact]
    public Task All_is_seen_at_first_and_again_at_another_size() => At((plot, _, window) =>
    {
        Assert.True(plot.ShowsAll);
        Assert.True(Shows(plot));
        window.Width = 500;
        new ScreenUser(window).Settle();
        Assert.True(plot.ShowsAll && Shows(plot) && plot.View.Width == plot.Bounds.Width);
    });

    [Fact]
    public Task The_wheel_zooms_about_the_pointer_and_the_buttons_about_the_middle() => At((plot, user, _) =>
    {
        var (middle, was) = (plot.View.ToPlot(new(plot.Bounds.Width / 2, plot.Bounds.Height / 2)), plot.View.ScaleX);
        user.Wheel(plot, 2);
        Assert.True(plot.View.ScaleX > was);
        Assert.True(plot.View.ToPlot(new(plot.Bounds.Width / 2, plot.Bounds.Height / 2)).DistanceTo(middle) < Small);
        var nearer = plot.View.ScaleX;
        user.Click(Button(plot, "nearer"));
        Assert.Equal(1.5, plot.View.ScaleX / nearer, 9);
        user.Click(Button(plot, "further"));
        Assert.Equal(nearer, plot.View.ScaleX, 9);
        user.Click(Button(plot, "all"));
        Assert.True(plot.ShowsAll);
    });

    [Fact]
    public Task Dragging_takes_the_place_under_the_finger_along() => At((plot, user, _) =>
    {
        user.Wheel(plot, 4);
        var place = plot.View.ToPlot(new(300, 200));
        user.Drag(plot, new(300, 200), new(240, 200));
        Assert.True(plot.View.ToPlot(new(240, 200)).DistanceTo(place) < Small);
        Assert.Null(plot.Values);
        place = plot.View.ToPlot(new(240, 200));
        user.Swipe(plot, new(240, 200), new(280, 200));
        Assert.True(plot.View.ToPlot(new(280, 200)).DistanceTo(place) < Small);
    });

    [Fact]
    public Task Two_fingers_zoom_as_far_as_they_part() => At((plot, user, _) =>
    {
        var was = plot.View;
        user.Pinch(plot, (new(290, 200), new(240, 200)), (new(310, 200), new(360, 200)));
        Assert.Equal(6, plot.View.ScaleX / was.ScaleX, 6);
        Assert.True(plot.View.ToPlot(new(300, 200)).DistanceTo(was.ToPlot(new(300, 200))) < Small);
    });

    [Fact]
    public Task A_tap_near_a_point_tells_its_exact_values_and_one_far_away_none() => At((plot, user, _) =>
    {
        var at = plot.View.ToScreen(new(100, 1));
        user.Click(plot, new(at.X - 15, at.Y + 10));
        Assert.Equal("B: error +0.0125\u00a0mm\npart +0.0200\u00a0mm", plot.Values);
        Assert.Equal(plot.Values, AutomationProperties.GetHelpText(plot));
        user.Click(plot, new(plot.Bounds.Width / 2, 30));
        Assert.Null(plot.Values);
    });

    [Fact]
    public Task The_drawing_cannot_be_lost() => At((plot, user, _) =>
    {
        for (var i = 0; i < 20; i++)
        {
            user.Drag(plot, new(300, 300), new(20, 20));
        }

        Assert.True(plot.View.Seen.Touches(new(0, 0, 100, 1)));
        plot.Zoom(1e-9, new(0, 0));
        Assert.True(Shows(plot));
        plot.Zoom(1e30, new(300, 200));
        Assert.True(double.IsFinite(plot.View.ToPlot(new(0, 0)).X));
    });

    [Fact]
    public Task Everything_goes_by_the_keyboard() => At((plot, user, _) =>
    {
        Assert.True(plot.Focus());
        var was = plot.View;
        user.Press(Key.Add);
        Assert.Equal(1.5, plot.View.ScaleX / was.ScaleX, 9);
        user.Press(Key.Right);
        Assert.True(plot.View.Middle.X > was.Middle.X);
        user.Press(Key.Left).Press(Key.Subtract);
        Assert.True(plot.View.Middle.DistanceTo(was.Middle) < Small);
        user.Press(Key.Add).Press(Key.D0);
        Assert.True(plot.ShowsAll);
        user.Press(Key.PageDown);
        Assert.StartsWith("A:", plot.Values, StringComparison.Ordinal);
        user.Press(Key.PageDown).Press(Key.PageDown);
        Assert.StartsWith("B:", plot.Values, StringComparison.Ordinal);
        user.Press(Key.PageUp);
        Assert.StartsWith("A:", plot.Values, StringComparison.Ordinal);
        user.Press(Key.Space);
        Assert.NotNull(plot.Values);
    });

    [Fact]
    public Task Other_data_are_seen_at_the_same_place_and_as_a_whole_if_they_lie_elsewhere() => At((plot, user, _) =>
    {
        user.Press(Key.None).Wheel(plot, 5);
        var was = plot.View;
        plot.Drawing = Gap(0.5);
        Assert.Equal(was, plot.View);
        plot.Drawing = Gap(1e6);
        Assert.True(plot.ShowsAll);
    });

    [Fact]
    public Task The_box_of_values_hides_no_line_and_no_button_and_lies_within() => At((plot, user, _) =>
    {
        // Up, down and up again: each point has a line at one of its sides, where the box would lie.
        (Geometry.Point2 A, Geometry.Point2 B, Geometry.Point2 C, Geometry.Point2 D) = (new(0, 0), new(30, 60), new(60, 0), new(90, 60));
        plot.Drawing = new(
            [[A, B, C, D]],
            [[A, B, C, D]],
            [("A", A, A, 0.1, 0, false), ("B", B, B, 0.1, 0, false), ("C", C, C, 0.1, 0, false), ("D", D, D, 0.1, 0, false)],
            new(0, 0, 90, 60),
            1,
            0.1,
            IsLong: false,
            IsTurned: false);
        Assert.True(plot.Focus());
        foreach (var name in new[] { "A", "B", "C", "D" })
        {
            user.Press(Key.PageDown);
            Assert.StartsWith(name + ":", plot.Values, StringComparison.Ordinal);
            var room = plot.ValuesRoom;
            Assert.True(new Avalonia.Rect(plot.Bounds.Size).Contains(room), $"{name} leaves the plot.");
            Assert.False(
                room.Intersects(Place(Button(plot, "nearer"))) || room.Intersects(Place(Button(plot, "all"))),
                $"{name} lies over a button.");
            var (low, high) = (plot.View.ToPlot(new(room.Left, room.Bottom)), plot.View.ToPlot(new(room.Right, room.Top)));
            Assert.False(new PlotBox(low.X, low.Y, high.X, high.Y).IsCrossedBy([A, B, C, D]), $"{name} hides a line.");
        }

        Avalonia.Rect Place(Button button) =>
            new(Avalonia.VisualExtensions.TranslatePoint(button, default, plot)!.Value, button.Bounds.Size);
    });

    [Fact]
    public Task Buttons_keep_away_from_the_frame_and_what_is_drawn_from_them() => At((plot, _, _) =>
    {
        var button = Button(plot, "nearer");
        var at = Avalonia.VisualExtensions.TranslatePoint(button, default, plot)!.Value;
        Assert.True(at.Y >= 6 && at.X + button.Bounds.Width <= plot.Bounds.Width - 6, $"{at}");
        Assert.True(plot.View.ToScreen(new(100, 1)).X < at.X - 6);
    });

    private static bool Shows(PlotArea plot) => plot.View.Seen is var seen && seen.Contains(new(0, 0)) && seen.Contains(new(100, 1));

    private static Button Button(PlotArea plot, string part) =>
        plot.GetVisualDescendants().OfType<Button>().Single(b => AutomationProperties.GetAutomationId(b) == "gap-" + part);

    internal static GapDrawing Gap(double from = 0) => new(
        [[new(from, 0), new(from + 100, 1)]],
        [[new(from, 1), new(from + 100, 0)]],
        [("A", new(from, 0), new(from, 1), 0.0005, 0.01, false), ("B", new(from + 100, 1), new(from + 100, 0), -0.0125, 0.02, false)],
        new(from, 0, from + 100, 1),
        1,
        0.0125,
        IsLong: true,
        IsTurned: false);

    private static Task At(Action<GapPlot, ScreenUser, Window> test) => Drawing.Needed().RunAsync(() =>
    {
        Texts.Current.Language = Language.English;
        var plot = new GapPlot { Drawing = Gap() };
        AutomationProperties.SetAutomationId(plot, "gap");
        var window = new Window { Width = 600, Height = 400, Content = plot };
        window.Show();
        try
        {
            test(plot, new ScreenUser(window).Settle(), window);
        }
        finally
        {
            window.Close();
        }
    });
}
