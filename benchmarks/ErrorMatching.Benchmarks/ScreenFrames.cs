using System.Globalization;
using Avalonia;
using Avalonia.Media;
using ErrorMatching.Cell;
using ErrorMatching.Hmi;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>The time of whole frames of each of the station's screens: everything is drawn again, as after a change of the background, with
/// the demonstration's cell, off screen with software rendering.</summary>
internal static class ScreenFrames
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(60), Look = TimeSpan.FromMilliseconds(800);
    private static readonly Size[] Sizes = [new(1920, 1080), new(3840, 2160)];

    /// <summary>Runs the figures.</summary>
    public static async Task<int> RunAsync()
    {
        Console.WriteLine("Whole frames of each screen, in ms");
        Console.WriteLine("| size | screen | median | longest | processor time |");
        Console.WriteLine("|---|---|---|---|---|");
        await DemoScreens.MeasureAsync(cell =>
        {
            Measure(cell);
            return Task.CompletedTask;
        });
        return 0;
    }

    private static void Measure(DemoCell cell)
    {
        using var station = new Station(cell.Settings, TimeProvider.System, Station.DefaultIdle);
        using var shell = Screens.ShellOf(station);
        var window = new MainWindow { DataContext = shell, Width = 1280, Height = 800 };
        window.Show();
        var user = new ScreenUser(window).Settle();
        try
        {
            user.WaitFor(
                () => station.State.Status is not null
                    && station.Store.Search(new()) is [{ State: CorrectionState.Proposed }, { State: CorrectionState.Proposed }],
                Patience);
            var login = (LoginViewModel)shell.Current!;
            (login.Name, login.Password) = (DemoCell.Setter, DemoCell.Password);
            login.SignIn.Execute(null);
            user.WaitFor(() => !shell.IsLocked, Patience);
            foreach (var size in Sizes)
            {
                (window.Width, window.Height) = (size.Width, size.Height);
                foreach (var screen in Screens.All)
                {
                    shell.Go(screen.Key);
                    user.Wait(Look).Settle();

                    // The background lies under everything.
                    var times = FrameTimes.Of(user, i => window.Background = i % 2 == 0 ? Brushes.White : Brushes.Snow);
                    Console.WriteLine(string.Create(
                        CultureInfo.InvariantCulture,
                        $"| {size.Width:0}x{size.Height:0} | {screen.Key} | {times.Median:0.0} | {times.Longest:0.0} "
                            + $"| {times.Processor:0.0} |"));
                }
            }
        }
        finally
        {
            window.Close();
        }
    }
}
