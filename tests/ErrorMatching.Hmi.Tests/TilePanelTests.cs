using Avalonia.Controls;

namespace ErrorMatching.Hmi.Tests;

public sealed class TilePanelTests
{
    [Theory]
    [InlineData(1, 1000, 494)]
    [InlineData(2, 1000, 494)]
    [InlineData(3, 1000, 325.33)]
    [InlineData(7, 1000, 325.33)]
    [InlineData(2, 611, 611)]
    [InlineData(2, 612, 300)]
    [InlineData(2, 200, 200)]
    public Task Tiles_share_the_width_and_none_is_narrower_than_it_may_be_while_there_is_room(int tiles, double width, double each) =>
        Drawing.Needed().RunAsync(() =>
    {
        var panel = Laid(width, [.. Enumerable.Range(1, tiles).Select(i => 40.0 * i)]);
        Assert.All(panel.Children, c => Assert.Equal(each, c.Bounds.Width, 1.0));
        Assert.Equal(tiles > 1 || width < 612 ? width : each, panel.Children.Max(c => c.Bounds.Right), 0.01);
    });

    [Fact]
    public Task Tiles_of_a_row_are_as_high_as_the_highest_and_rows_stand_below_each_other() => Drawing.Needed().RunAsync(() =>
    {
        var panel = Laid(1000, [40, 90, 60, 30]);
        Assert.Equal([(0, 90), (0, 90), (0, 90), (102, 30)], panel.Children.Select(c => (c.Bounds.Y, c.Bounds.Height)));
        Assert.Equal(132, panel.DesiredSize.Height);
    });

    private static TilePanel Laid(double width, double[] heights)
    {
        var panel = new TilePanel { LeastWidth = 300, Spacing = 12 };
        panel.Children.AddRange(heights.Select(h => new Border { MinHeight = h }));
        panel.Measure(new(width, double.PositiveInfinity));
        panel.Arrange(new(0, 0, width, panel.DesiredSize.Height));
        return panel;
    }
}
