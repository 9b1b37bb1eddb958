using ErrorMatching.Geometry;

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

    [Fact]
    public void Everything_drawn_is_in_the_parts_that_are_copied_and_close_to_where_it_belongs()
    {
        var random = new Random(3);
        var canvas = new PixelCanvas();
        for (var n = 0; n < 200; n++)
        {
            var (width, height, thick) = (random.Next(1, 300), random.Next(1, 200), random.Next(1, 5));
            double At(int size) => ((random.NextDouble() * 3) - 1) * size;
            var (x1, y1, x2, y2) = (At(width), At(height), At(width), At(height));
            canvas.Clear(width, height);
            Assert.False(canvas.Pixels.ContainsAnyExcept(0));
            canvas.Line(x1, y1, x2, y2, Cut, thick, isDashed: n % 5 == 0);
            canvas.Dot((int)At(width), (int)At(height), Rapid, PixelCanvas.Disk(thick));
            var touched = canvas.Changed.ToArray();
            for (var i = 0; i < width * height; i++)
            {
                var (x, y) = (i % width, i / width);
                if (canvas.Pixels[i] != 0)
                {
                    Assert.Contains(touched, r => r.ContainsExclusive(new Avalonia.PixelPoint(x, y)));
                }

                if (canvas.Pixels[i] == Cut)
                {
                    Assert.True(Distance(x + 0.5, y + 0.5) <= thick + 1);
                }
            }

            double Distance(double x, double y)
            {
                var (dx, dy) = (x2 - x1, y2 - y1);
                var t = Math.Clamp((((x - x1) * dx) + ((y - y1) * dy)) / Math.Max(1e-12, (dx * dx) + (dy * dy)), 0, 1);
                return Math.Sqrt(Math.Pow(x1 + (t * dx) - x, 2) + Math.Pow(y1 + (t * dy) - y, 2));
            }
        }
    }

    [Fact]
    public void Many_lines_at_once_are_the_same_pixels_as_one_after_the_other()
    {
        var random = new Random(4);
        var (atOnce, oneByOne) = (new PixelCanvas(), new PixelCanvas());
        for (var n = 0; n < 300; n++)
        {
            var (width, height, thick) = (random.Next(1, 150), random.Next(1, 150), random.Next(1, 6));
            var (wide, scale) = (random.Next(2) == 0 ? 1.2 : 0.02, 0.5 + random.NextDouble());
            var points = Enumerable.Range(0, random.Next(1, 40))
                .Select(i => (
                    At: new Point2(
                        width * ((wide * random.NextDouble()) + (n % 3 * 0.3)),
                        random.Next(8) == 0 ? random.Next(-5, height) : height * ((3 * random.NextDouble()) - 1)),
                    Begins: random.Next(6) == 0))
                .ToArray();
            atOnce.Clear(width, height);
            oneByOne.Clear(width, height);
            atOnce.Lines(points, scale, Cut, thick, isDashed: n % 7 == 0);
            for (var i = 1; i < points.Length; i++)
            {
                if (!points[i].Begins)
                {
                    var (a, b) = (points[i - 1].At, points[i].At);
                    oneByOne.Line(a.X * scale, a.Y * scale, b.X * scale, b.Y * scale, Cut, thick, isDashed: n % 7 == 0);
                }
            }

            Assert.True(oneByOne.Pixels.SequenceEqual(atOnce.Pixels));
            var copied = atOnce.Changed.ToArray();
            for (var i = 0; i < width * height; i++)
            {
                Assert.True(atOnce.Pixels[i] == 0 || copied.Any(r => r.ContainsExclusive(new Avalonia.PixelPoint(i % width, i / width))));
            }
        }
    }

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
