namespace ErrorMatching.Hmi.Tests;

public sealed class PixelCanvasTests
{
    private const int Rapid = 1, Cut = 2;

    [Fact]
    public void A_line_covers_the_pixels_from_end_to_end_and_no_others() => Assert.Equal(
        "......|.22222|......",
        Drawn(6, 3, c => c.Line(1.5, 1.5, 9.5, 1.5, Cut, 1, isDashed: false)));

    [Fact]
    public void A_thick_line_is_as_many_pixels_wide() => Assert.Equal(
        ".222..|.222..|.222..",
        Drawn(6, 3, c => c.Line(2.5, -5, 2.5, 20, Cut, 3, isDashed: false)));

    [Fact]
    public void A_dashed_line_has_gaps_and_goes_under_what_is_there() => Assert.Equal(
        "122111....11",
        Drawn(12, 1, c =>
        {
            c.Line(1.5, 0.5, 2.5, 0.5, Cut, 1, isDashed: false);
            c.Line(0.5, 0.5, 11.5, 0.5, Rapid, 1, isDashed: true);
        }));

    [Fact]
    public void A_dot_is_a_disk_and_is_cut_off_at_the_border() => Assert.Equal(
        "22...|222..|22...|2....",
        Drawn(5, 4, c => c.Dot(0, 1, Cut, PixelCanvas.Disk(2))));

    [Fact]
    public void What_was_drawn_before_is_wiped_also_at_another_size() => Assert.Equal("...", Drawn(3, 1, c => c.Clear(3, 1)));

    private static string Drawn(int width, int height, Action<PixelCanvas> draw)
    {
        var canvas = new PixelCanvas();
        canvas.Clear(20, 20);
        canvas.Line(0, 0, 20, 20, Cut, 3, isDashed: false);
        canvas.Clear(width, height);
        draw(canvas);
        return string.Join(
            '|',
            canvas.Pixels.ToArray()
                .Chunk(width)
                .Select(r => string.Concat(r.Select(p => p == 0 ? "." : p.ToString(System.Globalization.CultureInfo.InvariantCulture)))));
    }
}
