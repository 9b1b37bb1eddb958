using System.Collections;
using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using ErrorMatching.Geometry;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A plot of so many points that it is drawn pixel by pixel.</summary>
public sealed class PlotPaperTests
{
    private const int Width = 300, Height = 200;

    private static readonly Point2[] Noise = [.. Enumerable.Range(0, 20_000).Select(i => new Point2(i, 0.3 * Math.Sin(1.0 * i * i)))];

    [Fact]
    public Task No_point_is_hidden_by_its_neighbors() => At(Noise, (plot, _) =>
    {
        // One in a hundred is apart from the rest, and each of them is seen by itself.
        Point2[] points = [.. Noise.Select((p, i) => i % 100 == 50 ? p with { Y = 1 + (i % 700 / 700.0) } : p)];
        plot.HasLine = false;
        plot.Set(points);
        var pixels = Picture(plot);
        Assert.All(points.Select(plot.View.ToScreen), p => Assert.Equal(Colors.Red.ToUInt32(), pixels[((int)p.Y * Width) + (int)p.X]));
    });

    [Fact]
    public Task What_is_shown_does_not_depend_on_what_was_drawn_before() => At(Noise, (plot, user) =>
    {
        Point2[] data = [.. Noise];
        plot.Set(data);
        foreach (var act in new Action[]
        {
            () => plot.Pan(new(40, 60)),
            () => plot.Ask(new(data[5], "five", 5)),
            () => plot.Ask(null),
            () => plot.Zoom(40, new(100, 100)),
            () => plot.Ink = Brushes.Blue,
            plot.ShowAll,
            () =>
            {
                // In the same list, so that only the plot's renewal tells.
                Array.Reverse(data, 0, 10_000);
                plot.Set(data);
            },
            () => plot.Set(Noise[..100]),
            () => plot.Set(data),
        })
        {
            act();
            user.Settle();
            var shown = Picture(plot);
            var other = new Dotted { Ink = plot.Ink, Ground = plot.Ground };
            _ = Shown(other);
            other.Set([.. plot.Points]);
            plot.Twin = other;
            plot.Pan(default);
            Assert.Equal(plot.View, other.View);
            other.Ask(plot.Selected);
            Assert.Equal(0, Differing(shown, Picture(other)));
        }
    });

    [Fact]
    public Task Points_are_not_drawn_again_when_only_the_crosshair_moves()
    {
        var counted = new Counted(Noise);
        return At(counted, (plot, user) =>
        {
            plot.Ask(new(Noise[5], "five", 5));
            user.Settle();
            counted.Reads = 0;
            plot.Ask(new(Noise[9_000], "another", 9_000));
            user.Settle();
            Assert.Equal(0, counted.Reads);
            plot.Pan(new(1, 0));
            user.Settle();
            Assert.True(counted.Reads >= 2 * Noise.Length);
        });
    }

    private static Task At(IReadOnlyList<Point2> points, Action<Dotted, ScreenUser> test) => Drawing.Needed().RunAsync(() =>
    {
        var plot = new Dotted { Ink = Brushes.Red, Ground = Brushes.White };
        var (window, user) = Shown(plot);
        plot.Set(points);
        user.Settle();
        test(plot, user);
        window.Close();
    });

    private static (Window Window, ScreenUser User) Shown(Control content)
    {
        var window = new Window { Width = Width, Height = Height, Content = content };
        window.Show();
        return (window, new ScreenUser(window).Settle());
    }

    private static uint[] Picture(Control control)
    {
        using var drawn = new RenderTargetBitmap(new PixelSize(Width, Height));
        drawn.Render(control);
        var pixels = new uint[Width * Height];
        var pinned = GCHandle.Alloc(pixels, GCHandleType.Pinned);
        try
        {
            drawn.CopyPixels(
                new PixelRect(drawn.PixelSize), pinned.AddrOfPinnedObject(), pixels.Length * sizeof(uint), Width * sizeof(uint));
        }
        finally
        {
            pinned.Free();
        }

        return pixels;
    }

    private static int Differing(uint[] one, uint[] other) => one.Zip(other).Count(p => p.First != p.Second);

    private sealed class Dotted : PlotArea
    {
        public IReadOnlyList<Point2> Points { get; private set; } = [];

        public PlotDatum? Selected => Asked;

        public bool HasLine { get; set; } = true;

        protected override PlotBox Extent => PlotBox.Of(Points);

        protected override bool IsTrueToScale => false;

        public void Set(IReadOnlyList<Point2> points)
        {
            Points = points;
            Renew([]);
        }

        protected override void Draw(DrawingContext context, PlotView view)
        {
            if (HasLine)
            {
                Line(context, new Pen(Ink, 2), Points, view);
            }

            Dots(context, Ink, 2, Points, view);
        }
    }

    private sealed class Counted(IReadOnlyList<Point2> points) : IReadOnlyList<Point2>
    {
        public int Reads { get; set; }

        public int Count => points.Count;

        public Point2 this[int index]
        {
            get
            {
                Reads++;
                return points[index];
            }
        }

        public IEnumerator<Point2> GetEnumerator() => points.GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }
}
