using System.Text;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using ErrorMatching.Hmi.Cairo;
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
        var program = OpenedProgram.Read(Encoding.ASCII.GetBytes("N10 G1\nN20                X1\n"), NcDialects.FanucMill, TestContext.Current.CancellationToken);
        var text = new ProgramText { Picture = new(program), Width = 300, Height = 80 };
        var window = new Window { Width = 400, Height = 200, Content = text };
        window.Show();
        try
        {
            var user = new ScreenUser(window).Settle();
            var ground = ((ISolidColorBrush)text.Ground!).Color;
            var (corner, end) = (text.TranslatePoint(new(0, text.RowHeight), window)!.Value * scaling, text.RowsEnd.Single(r => r.Block == 1).End);
            var inked = Enumerable.Range(0, (int)(text.Width * scaling)).Last(x => Enumerable.Range(4, (int)(text.RowHeight * scaling) - 8).Any(y => user.PixelAt(new((int)corner.X + x, (int)corner.Y + y)) != ground));
            Assert.InRange(inked, (end - 3) * scaling, end * scaling);
        }
        finally
        {
            window.Close();
            OffScreenSession.Scaling = 1;
        }
    });
}
