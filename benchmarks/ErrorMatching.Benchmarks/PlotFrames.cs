using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using ErrorMatching.Geometry;
using ErrorMatching.Hmi;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>Frames of a plot with many points, off screen with software rendering.</summary>
internal static class PlotFrames
{
    public const int Points = 100_000;

    private static readonly Size[] Sizes = [new(1280, 800), new(1920, 1080), new(3840, 2160)];

    /// <summary>Runs the figures.</summary>
    /// <param name="width">Width of the window for which to run them; null for all.</param>
    public static async Task<int> RunAsync(string? width)
    {
        var session = OffScreenSession.Start(() => AppBuilder.Configure<App>());
        Console.WriteLine($"Plots of {Points} points; times of the thread of the screen in ms");
        FrameTimes.Head();
        foreach (var size in Sizes.Where(s => width is null || s.Width == double.Parse(width, CultureInfo.InvariantCulture)))
        {
            await session.RunAsync(() =>
            {
                var window = new Window { Width = size.Width, Height = size.Height };
                window.Show();
                try
                {
                    Measure(size, window, new ScreenUser(window).Settle());
                }
                finally
                {
                    window.Close();
                }
            });
        }

        return 0;
    }

    /// <summary>Measures the frames of a window's size.</summary>
    public static void Measure(Size size, Window window, ScreenUser user)
    {
        var noise = Enumerable.Range(0, Points)
            .Select(i => new Point2(i, Math.Sin(0.001 * i) + (0.3 * Math.Sin(1.0 * i * i))))
            .ToArray();
        var plot = new PointsPlot(noise);
        window.Content = plot;
        user.Settle();
        plot.Zoom(1.2, new(plot.Bounds.Width / 2, plot.Bounds.Height / 2));
        FrameTimes.Report(
            size, "panning nearly all points", FrameTimes.Of(user, i => plot.Pan(new(FrameTimes.Step(i), FrameTimes.Step(i)))));
        FrameTimes.Report(
            size,
            "asking for the next of them",
            FrameTimes.Of(user, i => plot.Ask(new(noise[(Points / 2) + i], "value", i))));
        plot.Ask(null);
        plot.Zoom(25, new(plot.Bounds.Width / 2, plot.Bounds.Height / 2));
        FrameTimes.Report(
            size, "panning a thirtieth of the points", FrameTimes.Of(user, i => plot.Pan(new(FrameTimes.Step(i), FrameTimes.Step(i)))));
    }
}
