using System.Globalization;
using System.Text;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>However many corrections wait, each can be reached and decided, and no count is that of what a list happens to have.</summary>
public sealed class ManyWaitingTests
{
    private const int Few = 130, Many = 10_000, Old = 1_003;

    [Fact]
    public Task A_correction_behind_a_hundred_others_is_listed_counted_and_decided() => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter);
            seat.WaitFor(() => seat.Station.State.Status is not null, "The cell is not seen.");
            var slot = ((OverviewViewModel)seat.Shell.Current!).Slots[0];
            Assert.Equal($"Nothing in line · to approve: {Few}", slot.Waiting);
            seat.Tap("nav-compensation");
            var page = (CompensationViewModel)seat.Shell.Current!;
            Assert.Equal(Enumerable.Range(1, Few).Select(i => (long)i), page.Rows.Select(r => r.Id));
            ((ListBox)seat.See("corrections")).ScrollIntoView(Few - 1);
            seat.Tap($"correction-{Few}").WaitFor(() => seat.TextOf("detail-title") == $"#{Few} · {Few}", "The last one is not shown.");
            seat.Tap("reject").Type("signing-reason", "not wanted").Tap("signing-confirm");
            seat.WaitFor(() => seat.Station.Store.Find(Few)!.State == CorrectionState.Rejected, "The last one is not decided.");
        },
        prepare: folder => Propose(folder, Few));

    [Fact]
    public Task What_a_filter_lists_is_rejected_with_one_reason_and_nothing_else_is() => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Operator);
            seat.WaitFor(() => seat.Station.State.Status is not null, "The cell is not seen.");
            seat.Tap("nav-compensation");
            var page = (CompensationViewModel)seat.Shell.Current!;
            Assert.False(page.CanRejectShown);
            Assert.Null(seat.Find("reject-shown"));
            seat.Type("corrections-filter", "· 12 vmc1");
            Assert.Equal([12L, 112L, .. Enumerable.Range(120, 10).Select(i => (long)i)], page.Rows.Select(r => r.Id));
            Assert.Equal($"12 of {Few}", seat.TextOf("corrections-listed"));
            seat.Tap("reject-shown").See("signing-reason");
            Assert.Equal("12 corrections", seat.TextOf("signing-subject"));
            Assert.Equal(12, seat.Shell.Signing!.Facts.Count);

            // Somebody decides one of them meanwhile.
            new CorrectionDecisions(seat.Station.Store).Approve(125, DemoCell.Setter, null);
            seat.Type("signing-reason", "probe was loose").Tap("signing-confirm");
            seat.WaitFor(() => seat.Station.Store.Find(129)!.State == CorrectionState.Rejected, "They are not rejected.");
            seat.WaitFor(() => page.Undone is not null, "What was not rejected is not told.");
            Assert.Contains("1 of 12", page.Undone, StringComparison.Ordinal);
            Assert.All(
                Enumerable.Range(1, Few),
                i =>
                {
                    var correction = seat.Station.Store.Find(i)!;
                    var isMeant = i is 12 or 112 or (>= 120 and <= 129 and not 125);
                    var left = i == 125 ? CorrectionState.Approved : CorrectionState.Proposed;
                    Assert.Equal(isMeant ? CorrectionState.Rejected : left, correction.State);
                    Assert.Equal(isMeant ? "probe was loose" : null, isMeant ? correction.Reason : null);
                });
            seat.Type("corrections-filter", "");
            seat.WaitFor(() => page.Rows.Count == Few - 11, "The rejected ones are still listed.");
        },
        prepare: folder => Propose(folder, Few));

    [Theory]
    [InlineData(1_050)]
    [InlineData(Many)]
    public Task However_many_wait_only_what_is_seen_is_laid_out(int count) => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter);
            seat.WaitFor(() => seat.Station.State.Status is not null, "The cell is not seen.");
            seat.Station.Pretend(Waiting(seat.Station, count));
            foreach (var screen in seat.Shell.Items.Select(i => i.Screen))
            {
                seat.Tap(screen.AutomationId).User.Settle();
                var controls = seat.Window.GetVisualDescendants().Count();
                Assert.True(controls < 20_000, $"{screen.Key} has {controls} controls.");
                if (screen.Key is ScreenKeys.Overview or ScreenKeys.Messages)
                {
                    // What is not listed is counted, and leads to where all of it is.
                    seat.Tap(screen.Key == ScreenKeys.Overview ? "overview-more" : "message-proposed");
                    seat.WaitFor(
                        () => seat.Shell.Chosen!.Screen.Key == ScreenKeys.Compensation, "What is left out leads nowhere.");
                }
            }

            seat.Tap("nav-compensation");
            Assert.Equal(count, ((CompensationViewModel)seat.Shell.Current!).Rows.Count);
            var list = (ListBox)seat.See("corrections");
            Assert.InRange(list.GetVisualDescendants().OfType<ListBoxItem>().Count(), 1, 40);
            list.ScrollIntoView(count - 1);
            seat.See("correction-" + Shown.Id(count));

            // Some more, some fewer, in the middle.
            var fewer = Waiting(seat.Station, count) is var all
                ? all with { Status = all.Status! with { Proposed = [.. all.Status!.Proposed.Where(c => c.Id % 1000 != 7)] } }
                : null!;
            seat.Station.Pretend(fewer);
            Assert.Equal(fewer.Status!.Proposed.Count, ((CompensationViewModel)seat.Shell.Current!).Rows.Count);
        },
        prepare: folder => Propose(folder, 1));

    // Each state that the overview lists comes from another part of the store.
    [Theory]
    [InlineData(CorrectionState.Failed, "Nothing in line", 31)]
    [InlineData(CorrectionState.Approved, "In line: 130", 0)]
    public Task Of_more_than_a_hundred_in_any_state_what_is_left_out_is_said_and_found(
        CorrectionState state, string inLine, int messagesLeft) => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter);
            seat.WaitFor(() => seat.Station.State.Status is not null, "The cell is not seen.");
            var overview = (OverviewViewModel)seat.Shell.Current!;
            Assert.Equal(Few, seat.Station.State.Status!.CountOf(state));
            Assert.Equal(inLine, overview.Slots[0].Waiting);
            Assert.Equal(Enumerable.Range(1, 100).Select(i => (long?)i), overview.Waiting.Select(t => (long?)t.Id));
            Assert.Equal("30 more wait. Tap to see everything to decide or in progress.", overview.More);

            // The cell does not run, which is a message of its own.
            seat.Tap("nav-messages");
            Assert.Equal(
                messagesLeft == 0 ? null : $"{messagesLeft} more messages. Tap to see everything to decide or in progress.",
                ((MessagesViewModel)seat.Shell.Current!).Left);
            Assert.Equal(messagesLeft == 0 ? 1 : 100, ((MessagesViewModel)seat.Shell.Current!).Messages.Count);

            seat.Tap("nav-overview").Tap("overview-more");
            seat.WaitFor(() => seat.Shell.Current is CompensationViewModel, "What is left out leads nowhere.");
            var rows = ((CompensationViewModel)seat.Shell.Current!).Rows;
            Assert.Equal(Enumerable.Range(1, Few).Select(i => (long)i), rows.Select(r => r.Id));
            ((ListBox)seat.See("corrections")).ScrollIntoView(Few - 1);
            seat.Tap($"correction-{Few}").WaitFor(() => seat.TextOf("detail-title") == $"#{Few} · {Few}", "The last one is not shown.");
            seat.Tap("reject").Type("signing-reason", "not wanted").Tap("signing-confirm");
            seat.WaitFor(() => seat.Station.Store.Find(Few)!.State == CorrectionState.Rejected, "The last one is not decided.");
        },
        prepare: folder => Bring(folder, Few, state));

    // What is not calculated yet is not to be decided, so no other list has it.
    [Fact]
    public Task More_than_a_hundred_that_are_not_calculated_yet_are_counted_and_not_said_to_be_elsewhere() => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter);
            seat.WaitFor(() => seat.Station.State.Status is not null, "The cell is not seen.");
            var overview = (OverviewViewModel)seat.Shell.Current!;
            Assert.Equal(Few, seat.Station.State.Status!.CountOf(CorrectionState.Archived));
            Assert.Equal(100, overview.Waiting.Count);
            Assert.Equal("Not calculated yet: 30 more.", overview.More);
            Assert.False(seat.See("overview-more").IsEffectivelyEnabled);

            // With something to decide before them, as much of both is left out.
            seat.Station.Pretend(Waiting(seat.Station, 105) is var some
                ? some with { Status = some.Status! with { InWork = seat.Station.State.Status!.InWork } }
                : null!);
            Assert.Equal(
                "5 more wait. Tap to see everything to decide or in progress. Not calculated yet: 130 more.", overview.More);
            seat.Tap("overview-more");
            Assert.Equal(105, ((CompensationViewModel)seat.Shell.Current!).Rows.Count);
        },
        prepare: folder => Bring(folder, Few, CorrectionState.Archived));

    [Fact]
    public Task The_history_says_how_many_it_leaves_out_and_finds_them() => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter).Tap("nav-history");
            var history = (HistoryViewModel)seat.Shell.Current!;
            seat.WaitFor(
                () => seat.TextOf("history-found") == "Found: 1,003. The latest 1,000 are shown. Narrow your search.",
                "It is not said how many are left out.");
            Assert.Equal(Enumerable.Range(4, Old - 3).Reverse().Select(i => (long)i), history.Rows.Select(r => r.Id));
            seat.Type("history-serial", "left-out").Tap("history-search").See("found-1");
            Assert.Equal(("Found: 1", 1), (seat.TextOf("history-found"), history.Rows.Count));
        },
        prepare: folder =>
        {
            Bring(folder, 1, CorrectionState.Recognized, "left-out");
            Bring(folder, Old - 1, CorrectionState.Archived);
        });

    // The same correction under other numbers.
    private static StationState Waiting(Station station, int count)
    {
        var (state, one) = (station.State, station.Store.Find(1)!);
        Correction[] all = [
            .. Enumerable.Range(1, count).Select(i => one with { Id = i, Serial = i.ToString(CultureInfo.InvariantCulture) })];
        var status = state.Status!;
        return state with
        {
            Status = status with
            {
                Proposed = all,
                Counts = new Dictionary<CorrectionState, long> { [CorrectionState.Proposed] = count },
                Slots = [status.Slots[0] with { Line = all }, .. status.Slots.Skip(1)],
            },
        };
    }

    private static void Propose(string folder, int count) => Bring(folder, count, CorrectionState.Proposed);

    // Corrections that have come so far.
    private static void Bring(string folder, int count, CorrectionState state, string? name = null)
    {
        var settings = CellSettingsReader.Read(Path.Combine(folder, "cell", "cell.json"));
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
        var (machine, job) = (settings.Machines[0], settings.Jobs[0]);
        for (var i = 1; i <= count; i++)
        {
            var serial = name ?? i.ToString(CultureInfo.InvariantCulture);
            var program = Encoding.ASCII.GetBytes($"(PART {serial})\nM30\n");
            var correction = store.Archive(
                new(settings.Gauges[0].Name, $"part-{serial}.csv", serial, Encoding.ASCII.GetBytes(serial), "trace")).Correction;
            if (state == CorrectionState.Archived)
            {
                continue;
            }

            correction = store.Step(
                correction,
                CorrectionState.Recognized,
                "cell",
                "by name",
                c => c with
                {
                    Job = job.Name,
                    Piece = "part",
                    Serial = serial,
                    Identity = "identity " + serial,
                    Machine = machine.Name,
                    Slot = machine.Slots[0].Name,
                    Program = machine.Slots[0].Program,
                });
            if (state is CorrectionState.Recognized)
            {
                continue;
            }

            if (state is CorrectionState.Failed)
            {
                store.Step(correction, state, "cell", "disk full", c => c with { Reason = "disk full", Identity = null });
                continue;
            }

            correction = store.Step(
                correction,
                CorrectionState.Computed,
                "cell",
                "computed",
                c => c with { ProgramSha256 = Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData(program)) },
                [program]);
            correction = store.Step(correction, CorrectionState.Proposed, "cell", "within limits");
            if (state is CorrectionState.Approved)
            {
                store.Step(correction, state, DemoCell.Setter, "approved");
            }
        }
    }
}
