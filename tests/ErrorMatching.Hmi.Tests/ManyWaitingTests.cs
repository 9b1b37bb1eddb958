using System.Globalization;
using System.Text;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>However many corrections wait, each can be reached and decided, and no count is that of what a list happens to have.</summary>
public sealed class ManyWaitingTests
{
    private const int Few = 130, Many = 10_000;

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
                    seat.Tap(screen.Key == ScreenKeys.Overview ? "overview-more" : "messages-more");
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

    private static void Propose(string folder, int count)
    {
        var settings = CellSettingsReader.Read(Path.Combine(folder, "cell", "cell.json"));
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
        var (machine, job) = (settings.Machines[0], settings.Jobs[0]);
        for (var i = 1; i <= count; i++)
        {
            var serial = i.ToString(CultureInfo.InvariantCulture);
            var program = Encoding.ASCII.GetBytes($"(PART {serial})\nM30\n");
            var correction = store.Archive(
                new(settings.Gauges[0].Name, $"part-{serial}.csv", serial, Encoding.ASCII.GetBytes(serial), "trace")).Correction;
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
            correction = store.Step(
                correction,
                CorrectionState.Computed,
                "cell",
                "computed",
                c => c with { ProgramSha256 = Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData(program)) },
                [program]);
            store.Step(correction, CorrectionState.Proposed, "cell", "within limits");
        }
    }
}
