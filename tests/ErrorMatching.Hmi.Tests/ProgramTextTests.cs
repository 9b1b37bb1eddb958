using System.Text;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using ErrorMatching.Hmi.Testing;
using ErrorMatching.Nc;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What is seen of a program's text, by pixels.</summary>
public sealed class ProgramTextTests
{
    [Theory]
    [InlineData(1.0)]
    [InlineData(1.25)]
    [InlineData(1.5)]
    [InlineData(2.0)]
    public Task A_line_is_drawn_as_far_as_it_goes_at_any_scaling(double scaling) => Drawing.Needed().RunAsync(() =>
    {
        OffScreenSession.Scaling = scaling;

        // A word behind a gap: in a picture that is shown too large, a letter that is cut through is not taken for the last one.
        var program = OpenedProgram.Read(
            Encoding.ASCII.GetBytes("N10 G1\nN20                X1\n"), NcDialects.FanucMill, TestContext.Current.CancellationToken);
        var text = new ProgramText { Picture = new(program), Width = 300, Height = 80 };
        var window = new Window { Width = 400, Height = 200, Content = text };
        window.Show();
        try
        {
            var user = new ScreenUser(window).Settle();
            var ground = ((ISolidColorBrush)text.Ground!).Color;
            var (corner, end) = (
                text.TranslatePoint(new(0, text.RowHeight), window)!.Value * scaling, text.RowsEnd.Single(r => r.Block == 1).End);
            var inked = Enumerable.Range(0, (int)(text.Width * scaling)).Last(
                x => Enumerable.Range(4, (int)(text.RowHeight * scaling) - 8).Any(
                    y => user.PixelAt(new((int)corner.X + x, (int)corner.Y + y)) != ground));
            Assert.InRange(inked, (end - 3) * scaling, end * scaling);
        }
        finally
        {
            window.Close();
            OffScreenSession.Scaling = 1;
        }
    });

    // The bar for scrolling sideways lies over a row.
    [Fact]
    public Task The_last_row_comes_out_from_under_the_bar_of_long_lines() => Drawing.Needed().RunAsync(() =>
    {
        var rows = string.Concat(Enumerable.Range(1, 50).Select(n => $"N{n} G1 X{n}\n"));
        Assert.Equal(0, RoomBelow(rows));
        Assert.Equal(1, RoomBelow(rows + "(" + new string('X', 300) + ")\n"));

        static double RoomBelow(string lines)
        {
            var program = OpenedProgram.Read(Encoding.ASCII.GetBytes(lines), NcDialects.FanucMill, TestContext.Current.CancellationToken);
            var text = new ProgramText { Picture = new(program) };
            var window = new Window
            {
                Width = 400,
                Height = 200,
                Content = new ScrollViewer
                {
                    HorizontalScrollBarVisibility = Avalonia.Controls.Primitives.ScrollBarVisibility.Auto,
                    Content = text
                }
            };
            window.Show();
            try
            {
                new ScreenUser(window).Settle();
                text.Offset = new(0, double.MaxValue);
                return (text.Offset.Y + text.Bounds.Height - (program.Count * text.RowHeight)) / text.RowHeight;
            }
            finally
            {
                window.Close();
            }
        }
    });
}
