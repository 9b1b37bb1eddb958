using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

public sealed class MemoryTests
{
    private const int Times = 200, Cycles = 10;

    [Fact]
    public Task Screens_that_were_left_leave_nothing_behind() => Seat.AtAsync(async seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter);
        (seat.Window.Width, seat.Window.Height) = (640, 480);
        var left = new List<WeakReference>();
        for (var i = 0; i < Times; i++)
        {
            foreach (var item in seat.Shell.Items)
            {
                left.Add(Open(seat, item));
            }

            // Frames are what takes longest, and what lets go of what was drawn.
            if (i % Cycles == 0)
            {
                seat.User.Settle(1);
            }
        }

        seat.Shell.Go(Screens.Overview);
        for (var i = 0; i < 10 && left.Count(r => r.IsAlive) > Slack(seat); i++)
        {
            // What is still being read in the background ends first.
            seat.User.Wait(TimeSpan.FromMilliseconds(300));
            await Task.Yield();
            GC.Collect();
            GC.WaitForPendingFinalizers();
            GC.Collect();
        }

        Assert.InRange(left.Count(r => r.IsAlive), 0, Slack(seat));
    });

    // The one that is open, and the ones that the last layout of each kind may still hold.
    private static int Slack(Seat seat) => 2 * seat.Shell.Items.Count;

    [System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.NoInlining)]
    private static WeakReference Open(Seat seat, NavigationItem item)
    {
        seat.Shell.Chosen = item;
        Avalonia.Threading.Dispatcher.UIThread.RunJobs(null);
        return new WeakReference(seat.Shell.Current);
    }
}
