using System.Globalization;
using System.Runtime.CompilerServices;
using Avalonia.Controls;
using Avalonia.Threading;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

[Trait("Length", "Long")]
public sealed class MemoryTests
{
    private const int Cycles = 10, Tries = 30;

    // What is left behind once is left behind each time; more times are for what is seldom.
    private static readonly int Times = int.Parse(
        Environment.GetEnvironmentVariable("ERRORMATCH_SCREENS") ?? "5", CultureInfo.InvariantCulture);

    [Fact]
    public Task Screens_that_were_left_leave_nothing_behind() => Seat.AtAsync(async seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter);
        (seat.Window.Width, seat.Window.Height) = (640, 480);
        var opened = new List<(string Name, WeakReference It)>();
        for (var i = 0; i < Times; i++)
        {
            foreach (var item in seat.Shell.Items)
            {
                opened.AddRange(Open(seat, item));
            }

            // Frames are what takes longest, and what lets go of what was drawn.
            if (i % Cycles == 0)
            {
                seat.User.Settle(1);
            }
        }

        seat.Shell.Go(ScreenKeys.Overview);
        for (var i = 0; i < Tries && Left(opened).Length > 0; i++)
        {
            // What is still being read in the background ends first, and what is drawn last lets go of what was drawn before.
            seat.User.Wait(TimeSpan.FromMilliseconds(300));
            await Task.Yield();
            GC.Collect();
            GC.WaitForPendingFinalizers();
            GC.Collect();
        }

        Assert.True(opened.Count > 2 * Times * seat.Shell.Items.Count, $"{opened.Count} were looked for.");
        Assert.Empty(Left(opened));
    },
    // On a busy machine this takes longer than a seat waits before it locks and shows its own screen.
    idle: TimeSpan.FromHours(2));

    private static string[] Left(List<(string Name, WeakReference It)> opened) => [.. opened.Where(o => o.It.IsAlive).Select(o => o.Name)];

    // Nothing here may stay on the stack of the test.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static List<(string Name, WeakReference It)> Open(Seat seat, NavigationItem item)
    {
        seat.Shell.Chosen = item;
        Dispatcher.UIThread.RunJobs(null);
        return [
            .. seat.Window.GetVisualDescendants()
                .OfType<UserControl>()
                .Cast<object>()
                .Append(seat.Shell.Current!)
                .Select(o => (o.GetType().Name, new WeakReference(o)))];
    }
}
