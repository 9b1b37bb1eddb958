using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.LogicalTree;
using Avalonia.Media;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Hmi.Testing;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The maps of a surface on the screen of on-line compensation, where the small window leaves them little room.</summary>
public sealed class SurfaceMapTests
{
    private static readonly string[] Maps = ["detail-map", "detail-map-expected"];

    [Theory]
    [InlineData(TouchSize.Standard)]
    [InlineData(TouchSize.Large)]
    [InlineData(TouchSize.Largest)]
    public Task A_map_has_room_for_what_it_shows_and_for_its_buttons_whatever_the_size_of_what_is_touched(TouchSize size) =>
        Seat.AtAsync(seat =>
    {
        Arrive(seat, size);
        var least = (double)Application.Current!.FindResource("PlotLeast")!;
        foreach (var map in Maps)
        {
            var plot = (SurfacePlot)seat.See(map);
            foreach (var button in new[] { "nearer", "further", "all" }.Select(b => seat.See($"{map}-{b}")))
            {
                // As by whoever scrolls there.
                button.BringIntoView();
                seat.User.Settle();
                Assert.True(
                    Seen(plot, seat).Inflate(0.5).Contains(In(button, seat)),
                    $"{map}: a button stands at {In(button, seat)}, and {Seen(plot, seat)} is seen.");
            }

            Assert.True(plot.Bounds.Height >= least, $"{map} is {plot.Bounds.Height:0} high.");
        }

        seat.Shell.IsDark = size == TouchSize.Largest;
        seat.User.Settle();
        seat.User.Screenshot(Repository.PathTo("artifacts", "screenshots", $"compensation-surface-targets-{size}.png"));
    });

    [Fact]
    public Task The_surface_is_seen_between_its_points_however_small_it_is() => Seat.AtAsync(seat =>
    {
        Arrive(seat, TouchSize.Largest);
        var plot = (SurfacePlot)seat.See(Maps[0]);
        Point2[] points = [.. plot.Drawing!.Points.Select(p => p.At)];
        var nearest = points.SelectMany((p, i) => points.Skip(i + 1).Select(q => (q - p).Length)).Min();
        Assert.Equal(nearest, plot.Drawing.NearestDistance(), 1e-12);
        foreach (var factor in new[] { 0.3, 1, 3 })
        {
            plot.ShowAll();
            plot.Zoom(factor, default);
            Assert.InRange(plot.DotRadius(plot.View), 0.5, Math.Max(0.5, 0.2 * nearest * plot.View.ScaleX));
        }

        // Near enough they are as large as they are to be seen.
        plot.Zoom(100, default);
        Assert.Equal(DrawnSizes.Dot, plot.DotRadius(plot.View));
    });

    [Fact]
    public Task A_point_on_the_border_is_seen_in_the_dark_as_well() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-freeform").See("map");
        seat.Shell.IsDark = true;
        seat.User.Settle();
        var map = (SurfacePlot)seat.See("map");
        var (x, y) = map.View.ToScreen(map.Drawing!.Points.MinBy(p => p.At.X).At);
        var dot = map.TranslatePoint(new(x, y), seat.Window)!.Value;

        // From its middle outwards: the dot, the ring around it, and the ground.
        byte[] light = [
            .. new[] { 0, DrawnSizes.Dot, 2 * DrawnSizes.Dot }.Select(away => seat.User.PixelAt(new((int)(dot.X - away), (int)dot.Y)).G)];
        Assert.True(light[1] > 128 && light[0] < 64 && light[2] < 64, $"It is {string.Join(", ", light)}.");
    });

    [Fact]
    public Task Of_two_maps_beside_each_other_both_have_numbers_or_none() => Seat.AtAsync(seat =>
    {
        Arrive(seat, TouchSize.Standard);
        var (map, other) = ((SurfacePlot)seat.See(Maps[0]), (SurfacePlot)seat.See(Maps[1]));

        // Numbers that are wider find less room.
        other.Drawing = other.Drawing! with
        {
            Points = [.. other.Drawing.Points.Select(p => ("-" + p.Label + p.Label + p.Label, p.At, p.Values))]
        };
        var seen = new HashSet<bool>();
        foreach (var factor in Enumerable.Repeat(1.3, 10))
        {
            map.Zoom(factor, new(map.Bounds.Width / 2, map.Bounds.Height / 2));
            Assert.Equal(map.ShowsNumbers, other.ShowsNumbers);
            seen.Add(map.ShowsNumbers);
        }

        Assert.Equal(2, seen.Count);
    });

    [Fact]
    public Task Only_maps_that_are_looked_at_are_made() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-freeform").See("map");
        Assert.Equal(["map"], Made());
        seat.Tap("tab-compare").See("map-radius");
        Assert.Equal(["map", "map-mirror", "map-radius"], Made());

        IEnumerable<string?> Made()
        {
            seat.User.Settle();
            var maps = seat.Window.GetLogicalDescendants().OfType<SurfacePlot>().Where(p => p.Drawing is not null).ToArray();
            Assert.True(maps.Length >= 4);
            return maps.Where(p => p.HasShapes).Select(AutomationProperties.GetAutomationId).Distinct().Order();
        }
    });

    // Drawn on black and on white: a pixel that is not the same shows the ground.
    [Fact]
    public Task No_ground_is_seen_between_the_colors() => Drawing.Needed().RunAsync(() =>
    {
        const int CountU = 9, CountV = 7, Width = 420, Height = 320;
        double[] values = [.. Enumerable.Range(0, CountU * CountV).Select(i => Math.Sin(1.3 * i))];
        var net = new SurfaceNet(
            CountU,
            CountV,
            [
                .. Enumerable.Range(0, CountU * CountV).Select(i => (U: i / CountV, V: i % CountV)).Select(
                    p => new Point3((9.7 * p.U) + (3.1 * p.V), (8.3 * p.V) - (2.3 * p.U), 0))],
            []);
        var plot = new SurfacePlot { Drawing = new(net, values, 1, [], ShowsWay: false) };
        var window = new Window { Width = Width, Height = Height, Content = plot };
        window.Show();
        try
        {
            var (black, white) = (Seen(Brushes.Black), Seen(Brushes.White));
            Assert.Equal((Colors.Black, Colors.White), (black[2, 2], white[2, 2]));
            var (inside, most) = (0, 0);
            for (var y = 0; y < Height; y++)
            {
                for (var x = 0; x < Width; x++)
                {
                    // Three pixels away from the border in each direction.
                    var isInside = new[] { (-3, -3), (3, -3), (3, 3), (-3, 3) }.All(
                        d => IsOnSurface(net, plot.View.ToPlot(new(x + 0.5 + d.Item1, y + 0.5 + d.Item2))));
                    if (isInside)
                    {
                        inside++;
                        most = Math.Max(most, Math.Abs(black[x, y].G - white[x, y].G));
                    }
                }
            }

            Assert.True(inside > 10_000, $"{inside} pixels are inside.");

            // A fiftieth of the range, where a border crosses the corner of a pixel aslant.
            Assert.Equal(0, most);
        }
        finally
        {
            window.Close();
        }

        Color[,] Seen(IBrush ground)
        {
            plot.Ground = ground;
            return new ScreenUser(window).Settle().Pixels();
        }
    });

    // The net is a parallelogram.
    private static bool IsOnSurface(SurfaceNet net, Point2 at)
    {
        Point2 Corner(int place) => new(net.Places[place].X, net.Places[place].Y);
        Point2[] corners = [
            Corner(0), Corner((net.CountU - 1) * net.CountV), Corner((net.CountU * net.CountV) - 1), Corner(net.CountV - 1)];
        var sides = Enumerable.Range(0, 4).Select(i => (corners[(i + 1) % 4] - corners[i]).Cross(at - corners[i])).ToArray();
        return sides.All(s => s > 0) || sides.All(s => s < 0);
    }

    private static void Arrive(Seat seat, TouchSize size)
    {
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter);
        seat.Shell.Preferences.TouchSize = size;
        seat.Tap("nav-compensation").See("detail-map");
        seat.User.Settle();
    }

    private static Rect In(Visual visual, Seat seat) =>
        new Rect(visual.Bounds.Size).TransformToAABB(visual.TransformToVisual(seat.Window)!.Value);

    private static Rect Seen(Visual visual, Seat seat) => visual.GetVisualAncestors()
        .Where(a => a.ClipToBounds)
        .Aggregate(In(visual, seat), (place, above) => place.Intersect(In(above, seat)));
}
