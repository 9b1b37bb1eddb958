using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A job is set up while corrections wait that were made with it as it was:
/// nobody takes one of those for one of the job as it is.</summary>
[Trait("Length", "Long")]
public sealed class ChangedJobTests
{
    [Fact]
    public Task What_was_made_before_its_job_was_changed_says_so_in_its_row_in_its_head_and_where_it_is_signed() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("detail-title");
        Assert.Null(seat.Find("detail-changed-job"));
        Assert.DoesNotContain("made before the job was changed", Words(seat));

        Change(seat.Station.Settings);
        seat.WaitFor(() => seat.Find("detail-changed-job") is not null, "It is not said that the job was changed.");
        Assert.StartsWith("Made before the job was changed.", seat.TextOf("detail-changed-job"), StringComparison.Ordinal);
        Assert.Contains("made before the job was changed", Words(seat));
        seat.WaitFor(() => seat.Find("approve") is { IsEffectivelyEnabled: true }, "It cannot be approved any more.");
        seat.Tap("approve").See("signing-subject");
        Assert.Contains(
            seat.See("signing-subject").FindAncestorOfType<Border>()!.GetVisualDescendants().OfType<TextBlock>(),
            t => t.Text?.Contains("Made before the job was changed.", StringComparison.Ordinal) == true);
        seat.Tap("signing-leave");
        seat.User.Screenshot(Repository.PathTo("artifacts", "screenshots", "compensation-changed-job-en.png"));
        Texts.Current.Language = Language.TraditionalChinese;
        seat.WaitFor(
            () => seat.TextOf("detail-changed-job")!.StartsWith("此補償以變更前的作業計算。", StringComparison.Ordinal), "It is said in English only.");
        seat.User.Settle();
        Assert.Empty(Layout.Problems(seat.Window));
        seat.User.Screenshot(Repository.PathTo("artifacts", "screenshots", "compensation-changed-job-zh.png"));
        Texts.Current.Language = Language.English;

        // The next one is made with the job as it is.
        seat.Cell.Deliver(2, 0.001);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Find("correction-2") is not null, "The part is not listed.");
        seat.Tap("correction-2").WaitFor(() => seat.TextOf("detail-title") == "#2 · 0002", "It is not shown.");
        Assert.Null(seat.Find("detail-changed-job"));

        // The overview tells them apart as well.
        seat.Tap("nav-overview").See("waiting-2");
        Assert.Equal([(1L, true), (2L, false)], ((OverviewViewModel)seat.Shell.Current!).Waiting.Select(t => (t.Id, t.IsOfChangedJob)));
        Assert.Contains("made before the job was changed", Words(seat, "waiting-1"));
    });

    [Fact]
    public async Task The_gauge_of_the_demonstration_goes_on_when_the_job_was_set_up()
    {
        using var folder = new TemporaryFolder();
        await using var cell = DemoCell.Make(folder.Path, TimeProvider.System);
        using var store = CellStore.Open(cell.Settings.Store, TimeProvider.System, AuditKey.Open(cell.Settings.KeysFolder));
        using var end = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        var clock = new SteppedClock();
        cell.Run();
        var day = new DemoDay(cell, clock).RunAsync(end.Token);
        await Wait(() => Parts().Length == 1);
        await Come(3);
        await Looks();

        // 40 s lie between two parts; the first one after a save comes 3 s after the one before.
        Change(cell.Settings);
        await Looks();
        Assert.Equal(3, Parts().Length);
        clock.Advance(TimeSpan.FromSeconds(3));
        await Wait(() => Parts().Length == 4);
        await Come(6);

        // Three wait, and no more come.
        clock.Advance(TimeSpan.FromMinutes(10));
        await Looks();
        Assert.Equal(6, Parts().Length);
        Assert.Equal(Parts().Take(3).Select(c => c.Id), new ChangedJobs(cell.Settings).Among(store, Parts()).Order());
        await end.CancelAsync();
        await day;

        async Task Come(int parts)
        {
            for (var next = Parts().Length + 1; next <= parts; next++)
            {
                await Looks();
                clock.Advance(TimeSpan.FromSeconds(40));
                await Wait(() => Parts().Length == next);
            }
        }

        // The gauge looks once for each time that it waits.
        Task Looks()
        {
            var enough = clock.Waits + 20;
            return Wait(() => clock.Waits > enough);
        }

        Correction[] Parts() => [.. store.Corrections.InState(CorrectionState.Proposed).Where(c => c.Piece == "part")];

        static async Task Wait(Func<bool> condition)
        {
            for (var begun = TimeProvider.System.GetTimestamp(); !condition();)
            {
                Assert.True(TimeProvider.System.GetElapsedTime(begun) < Seat.Patience, "It does not come to that.");
                await Task.Delay(20, TestContext.Current.CancellationToken);
            }
        }
    }

    // As by a save from the screen of coordinates: the job's own file stays the same to the byte.
    private static void Change(CellSettings settings)
    {
        var file = Path.Combine(Path.GetDirectoryName(settings.Jobs[0].File)!, "theoretical.csv");
        var text = File.ReadAllText(file);
        var changed = text.Replace("-31.95", "-31.951", StringComparison.Ordinal);
        Assert.NotEqual(text, changed);
        File.WriteAllText(file, changed);
    }

    private static IEnumerable<string?> Words(Seat seat, string id = "correction-1") =>
        seat.See(id).GetVisualDescendants().OfType<TextBlock>().Where(t => t.IsEffectivelyVisible).Select(t => t.Text);

    /// <summary>Stands still but for the steps it is given, so that nothing hangs on how busy the machine is;
    /// who waits by it waits a twentieth of the time.</summary>
    private sealed class SteppedClock : TimeProvider
    {
        private const int Times = 20;
        private long _now = 1;
        private int _waits;

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public int Waits => Volatile.Read(ref _waits);

        public void Advance(TimeSpan step) => Interlocked.Add(ref _now, step.Ticks);

        public override long GetTimestamp() => Interlocked.Read(ref _now);

        public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
        {
            Interlocked.Increment(ref _waits);
            return System.CreateTimer(
                callback, state, dueTime > TimeSpan.Zero ? dueTime / Times : dueTime, period > TimeSpan.Zero ? period / Times : period);
        }
    }
}
