using System.Globalization;
using Avalonia.Controls;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

public sealed class SeriesPlotTests
{
    [Theory]
    [InlineData(5, 1)]
    [InlineData(30, 2)]
    [InlineData(70, 5)]
    [InlineData(1000, 100)]
    public Task Places_are_named_in_even_steps(int count, int step) => Drawing.Needed().RunAsync(() =>
    {
        var names = Words(new(
            [.. Enumerable.Range(1, count).Select(i => i.ToString(CultureInfo.InvariantCulture))],
            [.. Enumerable.Repeat("", count)],
            [new(SeriesKind.Before, "line", [.. Enumerable.Range(0, count).Select(i => (double?)(i % 3))])],
            [],
            [],
            "µm"));
        Assert.Contains("µm", names);
        Assert.Equal(
            Enumerable.Range(1, count / step).Select(i => (step * i).ToString(CultureInfo.InvariantCulture)),
            names.Where(n => n.All(char.IsAsciiDigit) && n != "0").OrderBy(n => int.Parse(n, CultureInfo.InvariantCulture)));
    });

    [Fact]
    public Task Limits_that_lie_close_to_numbers_of_the_axis_are_said_before_them() => Drawing.Needed().RunAsync(() =>
    {
        var words = Words(new(["A", "B"], ["", ""], [new(SeriesKind.Before, "line", [-1, 1])], [new(0, 1, -0.21, 0.19)], []));
        Assert.All(["+0.19", "−0.21", "0", "+1.0", "−1.0"], w => Assert.Contains(w, words));
        Assert.DoesNotContain("+0.2", words);
        Assert.DoesNotContain("−0.2", words);
    });

    [Fact]
    public void What_lies_outside_with_compensation_is_ringed()
    {
        var drawing = new SeriesDrawing(
            ["A", "B", "C", "D", "E"],
            ["", "", "", "", ""],
            [new(SeriesKind.Before, "before", [9, 9, 9, 9, 9]), new(SeriesKind.After, "after", [-0.21, -0.2, null, 0.2, 0.31])],
            [new(0, 2, -0.2, 0.2), new(3, 3, -0.1, 0.1)],
            []);
        Assert.Equal([(0, -0.21), (3, 0.2)], drawing.Outside);
    }

    // All that is written in a plot of 700 by 400.
    private static HashSet<string> Words(SeriesDrawing drawing)
    {
        var plot = new SeriesPlot { Drawing = drawing };
        var window = new Window { Width = 700, Height = 400, Content = plot };
        window.Show();
        try
        {
            _ = new ScreenUser(window).Settle();
            return [.. ((IDrawnWords)plot).DrawnWords.Select(d => d.Words).Where(w => w.Length > 0)];
        }
        finally
        {
            window.Close();
        }
    }
}
