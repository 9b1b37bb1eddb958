using System.Diagnostics;
using System.Globalization;
using Avalonia.Threading;
using ErrorMatching.Cell;
using ErrorMatching.Hmi;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>How long a key press waits at the station while a screen opens, for the first time in the process and again: with the
/// demonstration's cell, off screen with software rendering.</summary>
internal static class StationScreens
{
    private const int Again = 5;
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(30), Look = TimeSpan.FromMilliseconds(500),
        Pause = TimeSpan.FromMilliseconds(1);

    /// <summary>Runs the figures.</summary>
    /// <param name="keys">The screens; none for all.</param>
    public static async Task<int> RunAsync(string[] keys)
    {
        Console.WriteLine("How long a key has to wait at most while a screen is opened, in ms");
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"| screen | first time | again, median of {Again} | longest of {Again} |"));
        Console.WriteLine("|---|---|---|---|");
        await DemoScreens.MeasureAsync(cell => MeasureAsync(cell, keys));
        return 0;
    }

    private static async Task MeasureAsync(DemoCell cell, string[] keys)
    {
        using var station = new Station(cell.Settings, TimeProvider.System, Station.DefaultIdle);
        var opening = Stopwatch.StartNew();
        using var shell = Screens.ShellOf(station);
        var window = new MainWindow { DataContext = shell, Width = 1280, Height = 800 };
        window.Show();
        var user = new ScreenUser(window).Settle();
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"| window with the login | {opening.Elapsed.TotalMilliseconds:0} | | |"));
        try
        {
            user.WaitFor(
                () => station.State.Status is not null
                    && station.Store.Search(new()) is [{ State: CorrectionState.Proposed }, { State: CorrectionState.Proposed }],
                Patience);

            // As the station does while a user signs in.
            using var end = new CancellationTokenSource();
            var asking = Task.Run(() => AskAsync(end.Token));
            var (rehearsing, rehearsal) = (Stopwatch.StartNew(), new Rehearsal(window, shell).RunAsync(CancellationToken.None));
            user.WaitFor(() => rehearsal.IsCompleted, Patience);
            await rehearsal;
            await end.CancelAsync();
            var waited = await asking;
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture, $"| rehearsal of {rehearsing.Elapsed.TotalSeconds:0.0} s | {waited:0} | | |"));
            var login = (LoginViewModel)shell.Current!;
            (login.Name, login.Password) = (DemoCell.Setter, DemoCell.Password);
            login.SignIn.Execute(null);
            user.WaitFor(() => !shell.IsLocked, Patience);
            foreach (var screen in Screens.All.Where(s => keys.Length == 0 || keys.Contains(s.Key)))
            {
                var other = screen.Key == ScreenKeys.Messages ? ScreenKeys.Settings : ScreenKeys.Messages;
                await OpenAsync(shell, user, other);
                var first = await OpenAsync(shell, user, screen.Key);
                var again = new List<double>();
                for (var i = 0; i < Again; i++)
                {
                    await OpenAsync(shell, user, other);
                    again.Add(await OpenAsync(shell, user, screen.Key));
                }

                var ordered = again.Order().ToArray();
                Console.WriteLine(string.Create(
                    CultureInfo.InvariantCulture, $"| {screen.Key} | {first:0} | {ordered[ordered.Length / 2]:0} | {ordered[^1]:0} |"));
            }
        }
        finally
        {
            window.Close();
        }
    }

    // Like a user who taps and then looks for a moment. Meanwhile another thread keeps checking whether a key would be accepted; its
    // longest wait is the user's longest wait.
    private static async Task<double> OpenAsync(ShellViewModel shell, ScreenUser user, string screen)
    {
        using var end = new CancellationTokenSource();
        var asking = Task.Run(() => AskAsync(end.Token));
        Dispatcher.UIThread.Post(() => shell.Go(screen), DispatcherPriority.Input);
        user.Wait(Look);
        await end.CancelAsync();
        return await asking;
    }

    private static async Task<double> AskAsync(CancellationToken end)
    {
        var longest = 0.0;
        while (!end.IsCancellationRequested)
        {
            var asked = Stopwatch.GetTimestamp();
            await Dispatcher.UIThread.InvokeAsync(
                () => longest = Math.Max(longest, Stopwatch.GetElapsedTime(asked).TotalMilliseconds), DispatcherPriority.Input);
            await Task.Delay(Pause, CancellationToken.None);
        }

        return longest;
    }
}
