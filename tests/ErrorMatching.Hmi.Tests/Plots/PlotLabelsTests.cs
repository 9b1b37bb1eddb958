using System.Globalization;
using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi.Tests;

public sealed class PlotLabelsTests
{
    private const double Away = 8, Dot = 3;
    private static readonly Rect All = new(-100, -100, 400, 300);

    [Fact]
    public Task A_label_stands_beside_its_place_where_no_line_is() => Drawing.Needed().RunAsync(() =>
    {
        var place = new Point(100, 100);
        var text = Text("12");

        Assert.True(new PlotLabels([], [place], Dot, All).Place(text, place, Away)!.Value.Corner.X > 100);
        Assert.True(new PlotLabels([[place, new(200, 100)]], [place], Dot, All).Place(text, place, Away)!.Value.Corner.X < 100);
        Assert.True(
            new PlotLabels([[new(0, 100), place, new(200, 100)]], [place], Dot, All).Place(text, place, Away)!.Value.Corner.Y
                + text.Height <= 100 - Away);
        return Task.CompletedTask;
    });

    [Fact]
    public Task Labels_never_lie_over_each_other_and_what_has_no_room_is_left_out() => Drawing.Needed().RunAsync(() =>
    {
        var text = Text("12");
        for (var seed = 0; seed < 100; seed++)
        {
            var random = new Random(seed);
            Point[] places = [.. Enumerable.Range(0, 40).Select(_ => new Point(200 * random.NextDouble(), 100 * random.NextDouble()))];
            var labels = new PlotLabels([places], places, Dot, new(0, 0, 200, 100));
            var rooms = places.Select(p => labels.Place(text, p, Away))
                .OfType<LabelRoom>()
                .Select(r => new Rect(r.Corner, new Size(text.Width, text.Height)))
                .ToArray();

            Assert.InRange(rooms.Length, 10, 39);
            Assert.All(rooms, r => Assert.DoesNotContain(rooms, o => o != r && o.Intersects(r)));
        }

        return Task.CompletedTask;
    });

    [Fact]
    public Task A_label_is_nearer_to_its_own_dot_than_to_any_other_or_a_line_leads_to_it() => Drawing.Needed().RunAsync(() =>
    {
        var text = Text("12");
        Point[] places = [.. Enumerable.Range(0, 5).Select(i => new Point(100, 100 + (8 * i)))];
        var labels = new PlotLabels([places], places, Dot, All);
        var led = 0;
        foreach (var place in places)
        {
            var (corner, leader) = labels.Place(text, place, Away)!.Value;
            var room = new Rect(corner, new Size(text.Width, text.Height));
            if (leader is var (from, to))
            {
                led++;
                Assert.Equal(place, from);
                Assert.Equal(0, DistanceOf(room, to), 1e-9);
                Assert.True(Point.Distance(from, to) > Away);
            }
            else
            {
                Assert.All(
                    places.Where(p => p != place),
                    p => Assert.True(DistanceOf(room, p) > 1.45 * DistanceOf(room, place), $"It may be taken for {p}."));
            }
        }

        Assert.InRange(led, 1, 4);

        return Task.CompletedTask;

        static double DistanceOf(Rect room, Point at) =>
            Point.Distance(at, new(Math.Clamp(at.X, room.Left, room.Right), Math.Clamp(at.Y, room.Top, room.Bottom)));
    });

    [Fact]
    public Task A_spare_label_is_left_out_rather_than_laid_over_a_line() => Drawing.Needed().RunAsync(() =>
    {
        var (text, place) = (Text("12"), new Point(100, 100));
        Point[][] net = [.. Enumerable.Range(0, 60).Select(i => new Point[] { new(0, 5 * i), new(300, 5 * i) })];
        var labels = new PlotLabels(net, [place], Dot, All);
        Assert.Null(labels.Place(text, place, Away, isSpare: true));
        Assert.NotNull(labels.Place(text, place, Away));
        return Task.CompletedTask;
    });

    [Fact]
    public Task A_spare_label_stands_at_the_height_of_its_place_or_is_left_out() => Drawing.Needed().RunAsync(() =>
    {
        // Lines at both sides leave room above, where it could be taken for another one's.
        var (text, place) = (Text("12"), new Point(100, 100));
        Point[][] sides = [[new(112, 95), new(112, 105)], [new(88, 95), new(88, 105)]];
        Assert.Null(new PlotLabels(sides, [place], Dot, All).Place(text, place, Away, isSpare: true));
        Assert.Equal(
            100 - (text.Height / 2), new PlotLabels(sides[..1], [place], Dot, All).Place(text, place, Away, isSpare: true)!.Value.Corner.Y);
        return Task.CompletedTask;
    });

    private static FormattedText Text(string words) =>
        new(words, CultureInfo.InvariantCulture, FlowDirection.LeftToRight, Typeface.Default, 14, Brushes.Black);
}
