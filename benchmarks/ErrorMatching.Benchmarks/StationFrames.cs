using System.Diagnostics;
using System.Globalization;
using System.Text;
using Avalonia;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Hmi;
using ErrorMatching.Hmi.Testing;
using ErrorMatching.Nc;

namespace ErrorMatching.Benchmarks;

/// <summary>The work of the station's UI thread with a program of a million blocks and a plot of 100,000 points: opening, and frames, off
/// screen with software rendering.</summary>
internal static class StationFrames
{
    private static readonly Size[] Sizes = [new(1280, 800), new(1920, 1080), new(3840, 2160)];

    /// <summary>Runs the figures.</summary>
    /// <param name="blocks">Number of blocks; null for a million.</param>
    public static async Task<int> RunAsync(string? blocks)
    {
        var folder = Directory.CreateTempSubdirectory("errormatch-station-").FullName;
        try
        {
            var file = Path.Combine(folder, "wave.nc");
            var count = blocks is null ? 1_000_000 : int.Parse(blocks, CultureInfo.InvariantCulture);
            Write(file, count);
            var session = OffScreenSession.Start(() => AppBuilder.Configure<App>());
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{count} blocks, a plot of {PlotFrames.Points} points; times of the thread of the screen in ms"));
            FrameTimes.Head();
            foreach (var size in Sizes)
            {
                await session.RunAsync(() => MeasureAsync(size, file));
            }

            return 0;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static async Task MeasureAsync(Size size, string file)
    {
        // Text is on the screen before a program is, and a small program was rehearsed: the station starts with its login.
        var window = new Window { Width = size.Width, Height = size.Height, Content = new TextBlock { Text = "Sample cell" } };
        window.Show();
        var user = new ScreenUser(window).Settle();
        var stage = new Panel { Opacity = 0, IsEnabled = false };
        window.Content = stage;
        stage.Children.Add(
            new ContentControl
            {
                Content = new ProgramPicture(OpenedProgram.Read(
                    "N10 G0 X0. Y0. Z5.\nN20 G1 Z0. F500.\nN30 X9.\n"u8.ToArray(), NcDialects.FanucMill))
            });
        user.Settle();
        try
        {
            await OpenAsync(window, user, size, file, "first ");
            window.Content = null;
            user.Settle();
            await OpenAsync(window, user, size, file, "");
            var (text, path) = (
                window.GetVisualDescendants().OfType<Hmi.ProgramText>().Single(),
                window.GetVisualDescendants().OfType<PathPlot>().Single());
            FrameTimes.Report(size, "scrolling by a row", FrameTimes.Of(user, _ => text.Offset += new Vector(0, text.RowHeight)));
            FrameTimes.Report(size, "scrolling by a page", FrameTimes.Of(user, _ => text.Offset += new Vector(0, text.Bounds.Height)));
            FrameTimes.Report(size, "lighting the next block", FrameTimes.Of(user, _ => text.Picture!.Move(1, isExtending: false)));
            FrameTimes.Report(
                size, "panning all of the path", FrameTimes.Of(user, i => path.Pan(new(FrameTimes.Step(i), FrameTimes.Step(i)))));
            path.Zoom(30, new(path.Bounds.Width / 2, path.Bounds.Height / 2));
            FrameTimes.Report(
                size, "panning a thirtieth of the path", FrameTimes.Of(user, i => path.Pan(new(FrameTimes.Step(i), FrameTimes.Step(i)))));
            FrameTimes.Report(
                size,
                "zooming the path",
                FrameTimes.Of(user, i => path.Zoom(i % 100 < 50 ? 0.95 : 1 / 0.95, new(path.Bounds.Width / 2, path.Bounds.Height / 2))));

            PlotFrames.Measure(size, window, user);
        }
        finally
        {
            window.Close();
        }
    }

    // A surface of 1 m by 1 m, finished in passes of 1,000 blocks each, so that the screen is full of its path.
    private static void Write(string file, int blocks)
    {
        using var text = new StreamWriter(file, append: false, new UTF8Encoding(false)) { NewLine = "\n" };
        text.WriteLine("%\nO1000\nN10 G21 G17 G40 G90 G54\nN20 G0 X0. Y0. Z5.\nN30 G1 Z-2. F500.");
        for (var i = 4; i < blocks - 2; i++)
        {
            var (pass, at) = (i / 1000, i % 1000);
            text.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"N{i * 10L} G1 X{(pass % 2 == 0 ? at : 999 - at):0.000} Y{pass + (0.4 * Math.Sin(0.05 * at)):0.000} "
                    + $"Z{-2 + Math.Sin(0.01 * pass):0.000}"));
        }

        text.WriteLine("M30\n%");
    }

    // From the file to the frame that shows text and path.
    private static async Task OpenAsync(Window window, ScreenUser user, Size size, string file, string which)
    {
        var watch = Stopwatch.StartNew();
        var program = await Task.Run(() => OpenedProgram.Read(File.ReadAllBytes(file), NcDialects.FanucMill));
        var read = watch.Elapsed;
        window.Content = new ContentControl { Content = new ProgramPicture(program) };
        user.Settle(1);
        var text = watch.Elapsed;
        var path = window.GetVisualDescendants().OfType<PathPlot>().Single();
        await path.Painting;
        var painted = watch.Elapsed;
        user.Settle(1);
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"| {FrameTimes.Shown(size)} | {which}opening: in the background {read.TotalMilliseconds:0}, until the text is seen "
                + $"{text.TotalMilliseconds:0}, until the path is seen {watch.Elapsed.TotalMilliseconds:0} | | | "
                + $"{Math.Max((text - read).TotalMilliseconds, (watch.Elapsed - painted).TotalMilliseconds):0.0} | |"));
    }
}
