using System.Globalization;
using Avalonia;
using Avalonia.Media;

namespace ErrorMatching.Hmi.Tests;

public sealed class PlotLabelsTests
{
    private const double Away = 8, Dot = 3;

    [Fact]
    public Task A_label_stands_beside_its_place_where_no_line_is() => Drawing.Needed().RunAsync(() =>
    {
        var place = new Point(100, 100);
        var text = Text("12");

        Assert.True(new PlotLabels([], [place], Dot).Place(text, place, Away)!.Value.X > 100);
        Assert.True(new PlotLabels([[place, new(200, 100)]], [place], Dot).Place(text, place, Away)!.Value.X < 100);
        Assert.True(new PlotLabels([[new(0, 100), place, new(200, 100)]], [place], Dot).Place(text, place, Away)!.Value.Y + text.Height <= 100 - Away);
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
            var labels = new PlotLabels([places], places, Dot);
            var rooms = places.Select(p => labels.Place(text, p, Away)).OfType<Point>().Select(p => new Rect(p, new Size(text.Width, text.Height))).ToArray();

            Assert.InRange(rooms.Length, 10, 39);
            Assert.All(rooms, r => Assert.DoesNotContain(rooms, o => o != r && o.Intersects(r)));
        }

        return Task.CompletedTask;
    });

    private static FormattedText Text(string words) => new(words, CultureInfo.InvariantCulture, FlowDirection.LeftToRight, Typeface.Default, 14, Brushes.Black);
}
