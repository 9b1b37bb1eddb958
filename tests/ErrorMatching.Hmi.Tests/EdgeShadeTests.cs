using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.VisualTree;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What is seen at the edges of what is scrolled.</summary>
public sealed class EdgeShadeTests
{
    private const double Row = 50;

    [Theory]
    [InlineData(2, 0, false, false)]
    [InlineData(9, 0, false, true)]
    [InlineData(9, 70, true, true)]
    [InlineData(9, 1000, true, false)]
    public Task An_edge_is_shaded_where_there_is_more_beyond_it(int rows, double scrolled, bool isAbove, bool isBelow) =>
        Drawing.Needed().RunAsync(() =>
    {
        var rowsInAll = new StackPanel { Spacing = 0 };
        rowsInAll.Children.AddRange(Enumerable.Range(0, rows).Select(_ => new Border { Height = Row }));
        var scroll = new ScrollViewer { Content = rowsInAll };
        var window = new Window { Width = 400, Height = 200, Content = scroll };
        window.Show();
        try
        {
            var user = new ScreenUser(window).Settle();
            var ground = user.PixelAt(new(10, 100));
            scroll.Offset = new(0, scrolled);
            user.Settle();
            Assert.Equal((isAbove, isBelow), (user.PixelAt(new(10, 0)) != ground, user.PixelAt(new(10, 199)) != ground));
            Assert.Equal(ground, user.PixelAt(new(10, 100)));
        }
        finally
        {
            window.Close();
        }
    });

    [Fact]
    public Task Every_bar_is_seen_as_long_as_there_is_more_and_rows_keep_their_width_under_it() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-messages").Tap("tab-trail");
        var screen = (MessagesViewModel)seat.Shell.Current!;
        seat.WaitFor(() => screen.Entries.Count > 0, "The trail stays empty.");
        var list = (ListBox)seat.See("audit");
        var head = list.GetVisualAncestors().OfType<DockPanel>().First().Children.OfType<Border>().Single();
        var bar = list.GetVisualDescendants().OfType<ScrollBar>().Single(b => b.Orientation == Avalonia.Layout.Orientation.Vertical);
        Assert.False(bar.IsVisible);
        var width = Widths();
        seat.Window.Height = 400;
        seat.WaitFor(() => bar.IsVisible, "There is more than is seen, and no bar.");
        Assert.Equal((10.0, false), (bar.Bounds.Width, bar.AllowAutoHide));
        Assert.Equal(width, Widths());

        // Columns stand under their heads.
        Grid HeadCells() => (Grid)head.Child!;
        Grid RowCells() => list.GetVisualDescendants().OfType<ListBoxItem>().First().GetVisualDescendants().OfType<Grid>().First();
        double[] Widths() => [
            .. new[]
            {
                HeadCells(),
                RowCells()
            }.SelectMany(g => g.Children.Skip(1).Select(c => c.TranslatePoint(default, seat.Window)!.Value.X))];
        Assert.Equal(
            HeadCells().Children.Skip(1).Select(c => c.TranslatePoint(default, seat.Window)!.Value.X),
            RowCells().Children.Skip(1).Select(c => c.TranslatePoint(default, seat.Window)!.Value.X));
    });
}
