using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

public sealed class OverviewTests
{
    [Fact]
    public Task A_cell_that_does_not_run_is_said_with_what_still_works() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Operator);
        Assert.StartsWith("The cell is not running: no gauge files are collected", seat.TextOf("banner"), StringComparison.Ordinal);
        Assert.Equal("The cell is not running", seat.TextOf("overview-summary"));
    });

    [Fact]
    public Task A_cell_with_nothing_to_do_is_quiet() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.SignIn(DemoCell.Operator).WaitFor(() => seat.TextOf("overview-summary") == "All is well", "All is not well.");
        Assert.Null(seat.Find("banner"));
        Assert.NotNull(seat.Find("slot-vmc1/A"));
        Assert.NotNull(seat.Find("gauge-cmm"));
    });

    [Fact]
    public Task A_program_that_waits_for_its_machine_says_why_in_both_languages() => Seat.AtAsync(seat =>
    {
        var why = Recorded.All.Single(f => f.Name == "machine-busy").With("vmc1", "running", "counterpart.nc", "counterpart.nc");
        var now = seat.Station.Clock.GetUtcNow();
        new Heartbeat(17, now, now, [])
        {
            Machines = [new("vmc1", new(MachineActivity.Running, ["counterpart.nc"], now))],
            Waiting = [new("vmc1", "A", 1, why.Text, now)],
        }.Write(seat.Station.Settings.LogFolder);
        seat.SignIn(DemoCell.Operator);
        var overview = (OverviewViewModel)seat.Shell.Current!;
        seat.WaitFor(() => overview.Slots is [{ State: "Waits for the machine" }, ..], "The machine is not said to be waited for.");
        Assert.Equal(
            ("vmc1 is running with the program counterpart.nc. counterpart.nc is replaced as soon as the machine is idle or runs another "
                + "program.",
                "Nothing in line · machine: running counterpart.nc", Severity.Quiet),
            (overview.Slots[0].Detail, overview.Slots[0].Waiting, overview.Slots[0].Severity));
        Texts.Current.Language = Language.TraditionalChinese;
        try
        {
            Assert.StartsWith("機台 vmc1 執行中", RecordedText.Of(why), StringComparison.Ordinal);
        }
        finally
        {
            Texts.Current.Language = Language.English;
        }
    });

    [Fact]
    public Task What_waits_at_a_gauge_is_said_with_number_and_age_in_both_languages() => Seat.AtAsync(seat =>
    {
        var now = seat.Station.Clock.GetUtcNow();
        var oldest = Shown.Time(now, seat.Station.Clock);
        seat.SignIn(DemoCell.Operator);
        var overview = (OverviewViewModel)seat.Shell.Current!;
        var english = $"1,069 files waiting, the oldest since {oldest}\n1 measurement not computed yet, since {oldest}";
        seat.WaitFor(() => Lives() && overview.Gauges[0].State == english, "It is not said what waits.");
        var why = Recorded.All.Single(f => f.Name == "backlog-grows").With("cmm", 1069, 1);
        var trouble = new CellTrouble(CellTrouble.OfBacklog("cmm"), CellCodes.BacklogGrows, why.Sentence, now) { Recorded = why.Text };
        seat.WaitFor(() => Lives(trouble) && overview.Gauges[0].Severity == Severity.Alarm, "A backlog that grows is no alarm.");
        Assert.StartsWith("What waits has grown for a minute: more arrives th", overview.Gauges[0].State, StringComparison.Ordinal);
        Texts.Current.Language = Language.TraditionalChinese;
        try
        {
            Assert.StartsWith("待處理項目已持續增加一分鐘：量測儀 cmm 有 1069 個檔案", RecordedText.Of(why), StringComparison.Ordinal);
        }
        finally
        {
            Texts.Current.Language = Language.English;
        }

        // However slow the test is, the cell has said a moment ago that it lives.
        bool Lives(params CellTrouble[] troubles)
        {
            new Heartbeat(17, now, seat.Station.Clock.GetUtcNow(), troubles) { Backlog = [new("cmm", 1069, now, 1, now)] }
                .Write(seat.Station.Settings.LogFolder);
            return true;
        }
    });

    [Fact]
    public Task A_measured_part_appears_by_itself() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.SignIn(DemoCell.Operator);
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(() => seat.TextOf("overview-summary") == "Waiting for approval: 1", "Nothing waits for an approval.");
        var tile = ((OverviewViewModel)seat.Shell.Current!).Waiting.Single();
        var kept = seat.Station.Store.Find(1)!;
        Assert.Equal(CorrectionState.Proposed, kept.State);
        Assert.Equal("#1 · 0001", tile.Title);
        Assert.Equal(Shown.Mm(kept.LargestMm) + " mm", tile.Largest);
        Assert.Equal(Severity.Quiet, tile.Severity);
    });

    [Fact]
    public Task What_is_abnormal_is_one_tap_away_and_has_a_word_and_an_icon_beside_its_color() => Seat.AtAsync(seat =>
    {
        File.WriteAllText(Path.Combine(seat.Cell.MachineFolder, "counterpart.nc"), "N10 G0 X0\n");
        seat.Cell.Run();
        seat.SignIn(DemoCell.Setter).WaitFor(() => seat.TextOf("overview-summary") == "All is well", "All is not well.");
        Assert.Empty(Colored(seat));
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.See("waiting-1");
        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Failed);
        seat.WaitFor(() => ((OverviewViewModel)seat.Shell.Current!).Waiting is [{ Severity: Severity.Alarm }], "It is no alarm.");
        Assert.Equal("Failed, waiting for a setter: 1", seat.TextOf("overview-summary"));
        Assert.Contains(Colored(seat), c => c is Avalonia.Controls.Shapes.Path);
        Assert.Contains(
            "Someone else changed the program at the machine.",
            seat.See("waiting-1").GetVisualDescendants().OfType<TextBlock>().Select(t => t.Text));
        seat.Tap("waiting-1").See("detail-title");
        Assert.Equal(("#1 · 0001", ScreenKeys.Compensation), (seat.TextOf("detail-title"), seat.Shell.Chosen!.Screen.Key));
        Assert.Contains("Someone else changed", seat.TextOf("detail-reason"), StringComparison.Ordinal);
    });

    [Fact]
    public Task A_free_machine_says_what_was_cut_last_and_leads_to_how_well_it_fits() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.SignIn(DemoCell.Operator).See("slot-vmc1/A");
        var overview = (OverviewViewModel)seat.Shell.Current!;
        seat.WaitFor(() => overview.Slots is [{ Detail: "No program sent yet." }, ..], "It is not said that none was sent.");
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);
        seat.Cell.FinishPiece();
        seat.WaitFor(
            () => overview.Slots[0] is
            {
                State: "Free", Severity: Severity.Quiet, Detail: "#1 · 0001 is cut and released; its counterpart is not measured yet."
            },
            "It is not said what was cut.");
        seat.Cell.DeliverCounterpart(1, 0);
        seat.WaitFor(
            () => overview.Slots[0] is
            {
                State: "Free", Severity: Severity.Quiet, Detail: "#1 · 0001 is cut and released, verified by #2."
            },
            "It is not said that it was measured.");
        seat.Tap("slot-vmc1/A").WaitFor(
            () => seat.Find("piece-title") is not null && seat.TextOf("piece-title") == "#1 · 0001",
            "The tap does not lead to the verification.");
        Assert.Equal((ScreenKeys.Verification, "Measured"), (seat.Shell.Chosen!.Screen.Key, seat.TextOf("piece-kind")));
    });

    [Fact]
    public Task What_waits_for_a_slot_that_is_taken_is_counted_at_it() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.SignIn(DemoCell.Operator).WaitFor(() => Texts(seat).Contains("Nothing in line"), "Something waits for the slot.");
        foreach (var serial in new[] { 1, 2, 3 })
        {
            seat.Cell.Deliver(serial, 0.02);
            seat.WaitFor(serial, CorrectionState.Proposed);
        }

        // Nobody has let any of them go yet: they are in no line.
        seat.WaitFor(
            () => Texts(seat).Contains("Nothing in line · to approve: 3"), "What waits for an approval is not told from what is in line.");
        foreach (var id in new[] { 1, 2, 3 })
        {
            new CorrectionDecisions(seat.Station.Store).Approve(id, DemoCell.Setter, null);
        }

        seat.WaitFor(() => Texts(seat).Contains("In line: 2"), "The two behind the first are not counted.");

        static IEnumerable<string?> Texts(Seat seat) =>
            seat.See("slot-vmc1/A").GetVisualDescendants().OfType<TextBlock>().Select(t => t.Text);
    });

    // What stands out: text, icons and borders in the colors of the abnormal.
    private static IEnumerable<Control> Colored(Seat seat) => seat.Window.GetVisualDescendants()
        .OfType<Control>()
        .Where(c => c.IsEffectivelyVisible && (c.Classes.Contains("alarm") || c.Classes.Contains("attention")));
}
