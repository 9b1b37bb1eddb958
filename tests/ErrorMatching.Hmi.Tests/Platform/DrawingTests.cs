using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;
using ErrorMatching.Hmi.Platform;
using SkiaSharp;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What ErrorMatching.Hmi.Platform draws, by closed forms.</summary>
public sealed class DrawingTests
{
    [Theory]
    [InlineData(GeometryCombineMode.Union, true, true, true)]
    [InlineData(GeometryCombineMode.Intersect, false, true, false)]
    [InlineData(GeometryCombineMode.Xor, true, false, true)]
    [InlineData(GeometryCombineMode.Exclude, true, false, false)]
    public Task Areas_are_combined(GeometryCombineMode mode, bool inFirst, bool inBoth, bool inSecond) => Drawing.Needed().RunAsync(() =>
    {
        // Two disks side by side, whose boxes contain points that neither of them does.
        var combined = new CombinedGeometry(mode, new EllipseGeometry(new(0, 0, 20, 20)), new EllipseGeometry(new(10, 0, 20, 20)));
        Assert.Equal(
            (inFirst, inBoth, inSecond, false),
            (
                combined.FillContains(new(3, 10)),
                combined.FillContains(new(15, 10)),
                combined.FillContains(new(27, 10)),
                combined.FillContains(new(15, 0.5))));
    });

    [Fact]
    public Task A_shadow_fades_as_CSS_says() => Drawing.Needed().RunAsync(() =>
    {
        // A long edge under a Gaussian with a standard deviation of half the blur radius: at a distance of d beyond the edge, the color is
        // there to the upper tail of the normal distribution, Q(d / 10). Centers of pixels are at 0.5, 9.5 and 19.5.
        const double blur = 20;
        using var drawn = new RenderTargetBitmap(new PixelSize(300, 300));
        using (var context = drawn.CreateDrawingContext())
        {
            context.FillRectangle(Brushes.White, new Rect(0, 0, 300, 300));
            context.DrawRectangle(
                Brushes.White, null, new Rect(0, 0, 150, 300), 0, 0, new BoxShadows(new BoxShadow { Blur = blur, Color = Colors.Black }));
        }

        var row = Pixels(drawn);
        double Dark(int x) => 1 - (row[(150 * 300) + x] / 255.0);
        Assert.Equal(0, Dark(148), 0.01);
        Assert.Equal(0.4801, Dark(150), 0.02);
        Assert.Equal(0.1711, Dark(159), 0.02);
        Assert.Equal(0.0256, Dark(169), 0.015);
    });

    [Fact]
    public Task A_brush_with_a_picture_paints_the_picture() => Drawing.Needed().RunAsync(() =>
    {
        using var picture = new RenderTargetBitmap(new PixelSize(10, 10));
        using (var context = picture.CreateDrawingContext())
        {
            context.FillRectangle(Brushes.Black, new Rect(0, 0, 5, 10));
            context.FillRectangle(Brushes.White, new Rect(5, 0, 5, 10));
        }

        using var drawn = new RenderTargetBitmap(new PixelSize(100, 100));
        using (var context = drawn.CreateDrawingContext())
        {
            context.FillRectangle(Brushes.White, new Rect(0, 0, 100, 100));
            context.FillRectangle(new ImageBrush(picture) { Stretch = Stretch.Fill }, new Rect(0, 0, 100, 100));
        }

        var pixels = Pixels(drawn);
        Assert.Equal((0, 255), (pixels[(50 * 100) + 20], pixels[(50 * 100) + 80]));
    });

    [Fact]
    public Task Text_covers_the_area_of_its_outlines() => Drawing.Needed().RunAsync(() =>
    {
        // Area by area, not by the guess of a renderer: small dark text must not become thin.
        foreach (var (text, weight) in new[] { ("−31.9500 kg", FontWeight.Normal), ("Complex mating", FontWeight.SemiBold) })
        {
            var words = new FormattedText(
                text,
                System.Globalization.CultureInfo.InvariantCulture,
                FlowDirection.LeftToRight,
                new Typeface(FontFamily.Default, FontStyle.Normal, weight),
                14,
                Brushes.Black);
            var outlines = words.BuildGeometry(new Point(5, 5))!;
            var (asText, asShape) = (Ink(c => c.DrawText(words, new Point(5, 5))), Ink(c => c.DrawGeometry(Brushes.Black, null, outlines)));
            Assert.InRange(asText / asShape, 0.97, 1.03);
        }

        static double Ink(Action<DrawingContext> draw)
        {
            using var drawn = new RenderTargetBitmap(new PixelSize(160, 30));
            using (var context = drawn.CreateDrawingContext())
            {
                context.FillRectangle(Brushes.White, new Rect(0, 0, 160, 30));
                draw(context);
            }

            return Pixels(drawn).Sum(v => 255.0 - v);
        }
    });

    [Fact]
    public Task Fonts_stay_where_HarfBuzz_and_Skia_read_them() => Drawing.Needed().RunAsync(() =>
    {
        // A soak: memory that moved or was freed ended in a segmentation fault after some collections.
        var fonts = new StationFonts(FontFolders.Own, FontFolders.Usual);
        var shaper = new HarfBuzzShaper();
        for (var i = 0; i < 30; i++)
        {
            foreach (var family in fonts.GetInstalledFontFamilyNames().Where(f => f.Contains("DejaVu", StringComparison.Ordinal)).Take(3))
            {
                Assert.True(fonts.TryCreateGlyphTypeface(
                    family, FontStyle.Normal, i % 2 == 0 ? FontWeight.Normal : FontWeight.Bold, FontStretch.Normal, out var found));
                var face = new GlyphTypeface(found, FontSimulations.None);
                var shaped = shaper.ShapeText($"Pass {i} fi 0.125".AsMemory(), new TextShaperOptions(face, 12));
                Assert.Equal(-1, shaped.ToList().FindIndex(g => g.GlyphIndex == 0));
                using var run = new SkiaGlyphRun(face, 12, [.. shaped], default);
                Assert.False(run.Outlines().IsEmpty);
            }

            GC.Collect(2, GCCollectionMode.Forced, blocking: true, compacting: true);
            GC.WaitForPendingFinalizers();
        }
    });

    [Fact]
    public void Damage_is_where_something_was_drawn()
    {
        var damage = new Damage(new PixelSize(100, 50));
        damage.Add(new SKRectI(10, 10, 20, 20));
        damage.Add(new SKRectI(12, 12, 15, 15));
        damage.Add(new SKRectI(90, 40, 120, 60));
        damage.Add(new SKRectI(200, 0, 210, 10));
        Assert.Equal([new PixelRect(10, 10, 10, 10), new PixelRect(90, 40, 10, 10)], damage.Rects);
        for (var i = 0; i < 9; i++)
        {
            damage.Add(new SKRectI(2 * i, 30, (2 * i) + 1, 31));
        }

        Assert.True(damage.Rects.Count <= 8);
        Assert.Contains(damage.Rects, r => r.Contains(new PixelRect(16, 30, 1, 1)));
        Assert.Contains(damage.Rects, r => r.Contains(new PixelRect(90, 40, 10, 10)));
        damage.All();
        Assert.Equal([new PixelRect(0, 0, 100, 50)], damage.Rects);
    }

    [Fact]
    public Task Only_what_changed_is_passed_on() => Drawing.Needed().RunAsync(() =>
    {
        using var frame = new SkiaBitmap(new PixelSize(100, 50), new Vector(96, 96));
        var damage = new Damage(frame.PixelSize);
        using (var context = frame.Draw(2, damage, null))
        {
            // Two units are four pixels.
            context.PushClip(new Rect(5, 5, 10, 10));
            context.DrawRectangle(Brushes.Red, null, new Rect(0, 0, 50, 25));
            context.PopClip();
        }

        Assert.Equal([new PixelRect(10, 10, 20, 20)], damage.Rects);
    });

    [Fact]
    public Task A_picture_that_lets_light_through_is_kept_as_it_is() => Drawing.Needed().RunAsync(() =>
    {
        // Unpremultiplied half red over blue: half of both.
        var pixels = Enumerable.Repeat(0x80FF0000u, 16).ToArray();
        using var source = Bitmap(pixels);
        using var drawn = new RenderTargetBitmap(new PixelSize(4, 4));
        using (var context = drawn.CreateDrawingContext())
        {
            context.FillRectangle(Brushes.Blue, new Rect(0, 0, 4, 4));
            context.DrawImage(source, new Rect(0, 0, 4, 4));
        }

        var copy = new uint[16];
        Copy(drawn, copy);
        Assert.All(copy, p =>
        {
            Assert.InRange(p >> 16 & 0xFF, 126u, 130u);
            Assert.InRange(p & 0xFF, 125u, 129u);
        });
    });

    private static unsafe Bitmap Bitmap(uint[] pixels)
    {
        fixed (uint* data = pixels)
        {
            return new Bitmap(
                PixelFormat.Bgra8888, AlphaFormat.Unpremul, (nint)data, new PixelSize(4, 4), new Vector(96, 96), 16);
        }
    }

    private static unsafe void Copy(Bitmap from, uint[] to)
    {
        fixed (uint* data = to)
        {
            from.CopyPixels(new PixelRect(from.PixelSize), (nint)data, to.Length * 4, from.PixelSize.Width * 4);
        }
    }

    // The green of each pixel.
    private static byte[] Pixels(Bitmap drawn)
    {
        var pixels = new uint[drawn.PixelSize.Width * drawn.PixelSize.Height];
        Copy(drawn, pixels);
        return [.. pixels.Select(p => (byte)(p >> 8))];
    }
}
