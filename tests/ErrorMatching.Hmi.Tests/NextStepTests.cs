using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Once a correction is decided about, the station says what comes next, who does it, and what is to do,
/// in the same words on each screen.</summary>
public sealed class NextStepTests
{
    private const string Cut = "Next: machine vmc1 cuts the piece, then gauge cmm measures it; nothing to do here until then.";
    private const string Measure =
        "Next: gauge cmm measures the piece; Verification then shows how well it fits. Nothing to do here until then.";

    private static readonly CellSettings Settings = CellSettingsReader.Read(Path.Combine(
        AppContext.BaseDirectory, "samples", "cell", "cell.json"));

    private static readonly Correction Part = new(
        1, CorrectionState.Approved, 1, "cmm", "part-0001.csv", DateTimeOffset.UnixEpoch, new string('0', 64), 1)
    {
        Job = "complex-mating",
        Piece = "part",
        Machine = "vmc1",
        Slot = "A",
        ProgramSha256 = new string('1', 64),
    };

    private static readonly Correction Surface = Part with { Job = "surface-one", Piece = "surface", Machine = "mill" };

    [Fact]
    public Task From_the_approval_to_the_measured_counterpart_both_screens_say_what_comes_next() =>
        Seat.AtAsync(prepare: WantedGap.In, test: seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-verification").See("piece-to-do");
        seat.WaitFor(
            () => seat.TextOf("piece-to-do")
                == "Before cutting, read the warnings of the correction: 1, 2 will stay outside. Next: approve or reject it in On-line "
                    + "compensation.",
            "What to do is not said.");
        seat.Tap("nav-compensation").See("pair");

        // What is to be decided here the buttons say.
        Assert.Null(seat.Find("compensation-next"));
        seat.Tap("approve").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(
            () => seat.Find("compensation-next") is not null && seat.TextOf("compensation-next") == Cut, "It is not said what comes next.");
        BothLanguages.Take(seat, "compensation-next");
        seat.Tap("nav-verification").See("piece-to-do");
        seat.WaitFor(
            () => seat.TextOf("piece-to-do") == "Before cutting, read the warnings of the correction: 1, 2 will stay outside. " + Cut,
            "What to do is not said.");

        // It follows by itself, and nothing is read before a cut that was made.
        seat.Cell.FinishPiece();
        seat.WaitFor(() => seat.TextOf("piece-to-do") == Measure, "The verification does not follow.");
        seat.Tap("nav-compensation").See("corrections");
        seat.Shell.Look(1);
        seat.WaitFor(
            () => seat.Find("compensation-next") is not null && seat.TextOf("compensation-next") == Measure,
            "It is not said that it is to be measured.");
        seat.Cell.DeliverCounterpart(1, 0);
        seat.WaitFor(() => seat.Find("compensation-next") is null, "What is measured is still to be measured.");
        Assert.Equal("Nothing is left to decide for this piece. Choose another one on the left.", seat.TextOf("forbidden"));
    });

    [Fact]
    public Task While_the_machine_is_away_it_is_said_that_nothing_is_to_do() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        Directory.Move(seat.Cell.MachineFolder, seat.Cell.MachineFolder + "-away");
        seat.Tap("approve").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(
            () => seat.Find("compensation-next") is not null
                && seat.TextOf("compensation-next")
                    == "Next: it goes to machine vmc1 when that answers again. The cell keeps trying; nothing to do here.",
            "It is not said what it waits for.");
        Directory.Move(seat.Cell.MachineFolder + "-away", seat.Cell.MachineFolder);
        seat.WaitFor(() => seat.TextOf("compensation-next") == Cut, "It does not follow.");
    });

    [Fact]
    public void Each_state_has_its_next_step() => Assert.Equal(
        [
            (CorrectionState.Archived, null), (CorrectionState.Recognized, null), (CorrectionState.Computed, null),
            (CorrectionState.Proposed, "Next: approve or reject it in On-line compensation."),
            (CorrectionState.Approved, "Next: it goes to machine vmc1 automatically; nothing to do until then."),
            (CorrectionState.Uploading, "Next: it goes to machine vmc1 automatically; nothing to do until then."),
            (CorrectionState.Verified, Cut),
            (CorrectionState.Released, Measure),
            (CorrectionState.Superseded, null), (CorrectionState.Recorded, null), (CorrectionState.Refused, null),
            (CorrectionState.Rejected, null),
            (CorrectionState.Failed, "Fix the problem, then approve it again, or reject it. Those behind it in line wait."),
            (CorrectionState.Reverted, "Its program was withdrawn: no more pieces are cut with it."),
        ],
        Enum.GetValues<CorrectionState>()
            .OrderBy(s => s is CorrectionState.Failed or CorrectionState.Reverted)
            .Select(s => (s, NextStep.Of(Settings, null, Part with { State = s }))));

    [Fact]
    public void A_program_that_nobody_made_can_only_be_measured_again() =>
        Assert.Equal(
            "Fix the problem, reject it, and measure again.",
            NextStep.Of(Settings, null, Part with { State = CorrectionState.Failed, ProgramSha256 = null }));

    [Fact]
    public void Where_the_cell_stands_it_goes_on_once_the_cell_runs() =>
        Assert.Equal(
            "Next: it goes to machine vmc1 when the cell runs again; nothing else to do.",
            NextStep.Of(Settings, new(null, false, [], [], [], [], new Dictionary<CorrectionState, long>()), Part));

    [Fact]
    public void A_machine_that_does_not_say_that_it_has_cut_is_released_by_a_person()
    {
        var silent = Settings with
        {
            Machines = [.. Settings.Machines.Select(m => m with { Slots = [.. m.Slots.Select(s => s with { ReadyFile = null })] })]
        };
        Assert.Equal(
            "Next: machine vmc1 cuts the piece. When it is cut, release the slot in On-line compensation; then gauge cmm measures the "
                + "piece.",
            NextStep.Of(silent, null, Part with { State = CorrectionState.Verified }));
        Assert.Equal(
            "Next: machine mill cuts the piece. When it is cut, release the slot in On-line compensation.",
            NextStep.Of(silent, null, Surface with { State = CorrectionState.Verified }));
    }

    [Fact]
    public void Nobody_is_said_to_measure_what_no_gauge_measures()
    {
        Assert.Equal(
            "Next: machine mill cuts the piece; nothing to do here until then.",
            NextStep.Of(Settings, null, Surface with { State = CorrectionState.Verified }));
        Assert.Null(NextStep.Of(Settings, null, Surface with { State = CorrectionState.Released }));
        var without = Settings with { Jobs = [.. Settings.Jobs.Where(j => j.Piece != "counterpart")] };
        Assert.Equal(
            "Next: machine vmc1 cuts the piece; nothing to do here until then.",
            NextStep.Of(without, null, Part with { State = CorrectionState.Verified }));
        Assert.Null(NextStep.Of(without, null, Part with { State = CorrectionState.Released }));
    }
}
