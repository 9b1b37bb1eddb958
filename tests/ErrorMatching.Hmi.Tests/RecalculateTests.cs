using Avalonia;
using Avalonia.Input;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What was made before its job was changed is recalculated from the station:
/// one by one, and all together where the job is saved.</summary>
[Trait("Length", "Long")]
public sealed class RecalculateTests
{
    [Fact]
    public Task One_tap_computes_it_with_the_job_as_it_is_and_shows_what_comes_of_it() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.Cell.Deliver(2, 0.001);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator)
            .Tap("nav-compensation")
            .WaitFor(() => seat.Find("detail-title") is not null && seat.TextOf("detail-title") == "#1 · 0001", "It is not shown.");
        Assert.False(seat.See("recalculate").IsEffectivelyEnabled);

        Change(seat, "-31.95", "-31.951");
        seat.WaitFor(() => seat.See("recalculate").IsEffectivelyEnabled, "It cannot be recalculated.");
        Assert.Contains("accent", seat.See("recalculate").Classes);
        Assert.DoesNotContain("accent", seat.See("approve").Classes);
        Assert.Equal("Made before the job was changed. To use the current job, recalculate this.", seat.TextOf("detail-changed-job"));
        BeClean(seat, "compensation-recalculate");
        seat.Tap("recalculate").WaitFor(
            () => seat.TextOf("detail-title") == "#3 · 0001" && seat.TextOf("detail-state") == Texts.Current.Word(CorrectionState.Proposed),
            "What came of it is not shown.");
        Assert.Null(seat.Find("signing-subject"));
        Assert.Null(seat.Find("compensation-undone"));
        Assert.Equal(
            (CorrectionState.Superseded, "computed-anew"), seat.Station.Store.Find(1) is var old ? (old!.State, old.Code) : default);
        Assert.Equal(
            "Its job was changed after it was made: correction 3 recalculates the measurement with the current job.",
            CodeText.Of(old!.Code!, old.Reason));
        Assert.Contains(
            (DemoCell.Operator, CorrectionState.Superseded), seat.Station.Store.Corrections.StepsOf(1).Select(s => (s.By, s.To)));

        // In the place of the one before, chosen, and made with the job as it is.
        seat.WaitFor(
            () => Rows(seat).Select(r => (r.Id, r.IsOfChangedJob)).SequenceEqual([(3L, false), (2L, true)]),
            "It does not stand in its place.");
        Assert.Equal(3, ((CompensationViewModel)seat.Shell.Current!).Chosen?.Id);
        Assert.False(seat.See("recalculate").IsEffectivelyEnabled);
        Assert.Null(seat.Find("detail-changed-job"));

        // By the keyboard as well, and what was recalculated once can be again.
        Change(seat, "-31.951", "-31.952");
        seat.WaitFor(() => seat.Find("recalculate") is { IsEffectivelyEnabled: true }, "It is not offered a second time.");
        seat.See("recalculate").Focus();
        seat.User.Press(Key.Enter);
        seat.WaitFor(() => seat.TextOf("detail-title") == "#4 · 0001", "The keyboard does nothing.");
        seat.WaitFor(4, CorrectionState.Proposed);

        // Everywhere in the order in which the pieces were measured.
        seat.WaitFor(
            () => seat.Station.State.Status!.Proposed.Select(c => c.Id).SequenceEqual([4L, 2L]),
            "It stands behind what was measured after it.");
        seat.Tap("nav-verification").WaitFor(
            () => ((VerificationViewModel)seat.Shell.Current!).Rows.Select(r => r.Id).SequenceEqual([2L, 4L]),
            "It stands as the last piece.");
    });

    [Fact]
    public Task What_is_approved_in_line_has_the_button_and_what_is_at_its_machine_has_none() => Seat.AtAsync(seat =>
    {
        var decisions = new CorrectionDecisions(seat.Station.Store);
        seat.Cell.Run();
        for (var i = 1; i <= 3; i++)
        {
            seat.Cell.Deliver(i, 0.001 * i);
            seat.WaitFor(i, CorrectionState.Proposed);
            if (i != 2)
            {
                decisions.Approve(i, DemoCell.Setter, null);
                seat.WaitFor(i, i == 1 ? CorrectionState.Verified : CorrectionState.Approved);
            }
        }

        seat.SignIn(DemoCell.Setter)
            .Tap("nav-compensation")
            .Tap("correction-3")
            .WaitFor(() => seat.TextOf("detail-title") == "#3 · 0003", "It is not shown.");
        var (recalculate, waits) = (seat.See("recalculate").Bounds, seat.See("compensation-waits").Bounds);
        Assert.False(seat.See("recalculate").IsEffectivelyEnabled);

        // It has room beside what it waits for, before its job is changed and then.
        Change(seat, "-31.95", "-31.951");
        seat.WaitFor(() => seat.See("recalculate").IsEffectivelyEnabled, "It cannot be recalculated.");
        Assert.Equal((recalculate, waits), (seat.See("recalculate").Bounds, seat.See("compensation-waits").Bounds));
        BeClean(seat);
        seat.Tap("correction-1").WaitFor(() => seat.TextOf("detail-title") == "#1 · 0001", "It is not shown.");
        seat.See("release");
        Assert.Null(seat.Find("recalculate"));
        seat.Tap("correction-3").Tap("recalculate").WaitFor(4, CorrectionState.Proposed);
        Assert.Equal(
            [CorrectionState.Verified, CorrectionState.Proposed, CorrectionState.Superseded],
            Enumerable.Range(1, 3).Select(i => seat.Station.Store.Find(i)!.State));
    });

    [Fact]
    public Task Who_must_not_any_more_changes_nothing_and_is_told() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        Change(seat, "-31.95", "-31.951");
        seat.SignIn(DemoCell.Operator).Tap("nav-compensation").See("recalculate");
        seat.Station.Users.Disable(seat.Station.Users.SignIn(DemoCell.Administrator, DemoCell.Password), DemoCell.Operator);
        seat.Tap("recalculate").WaitFor(() => seat.Find("compensation-undone") is not null, "Nothing is said.");
        Assert.StartsWith("This user is disabled.", seat.TextOf("compensation-undone"), StringComparison.Ordinal);
        Assert.Null(seat.Station.Store.Find(2));

        // What happens in the cell meanwhile takes nothing of that away.
        seat.Cell.Deliver(2, 0.001);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.See("correction-2");
        Assert.StartsWith("This user is disabled.", seat.TextOf("compensation-undone"), StringComparison.Ordinal);
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
    });

    [Fact]
    public Task Where_a_job_is_saved_all_that_wait_are_computed_anew_and_one_that_cannot_be_is_told() => SetupSeat.AtAsync("system", here =>
    {
        var (seat, store) = (here.Seat, here.Seat.Station.Store);
        var decisions = new CorrectionDecisions(store);
        seat.Cell.Run();
        for (var i = 1; i <= 4; i++)
        {
            seat.Cell.Deliver(i, 0.001);
            seat.WaitFor(i, CorrectionState.Proposed);
        }

        decisions.Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);
        decisions.Approve(2, DemoCell.Setter, null);
        seat.Tap("side-machine").Type("edit-compensation.gain", "0.5");
        here.Settle();
        var before = Top();
        seat.Save().WaitFor(() => seat.Find("setup-notice") is not null, "It is not saved.");
        seat.See("setup-recalculate");
        Assert.Equal(before, Top());
        Assert.Contains("Waiting, calculated with the old job: 3.", seat.TextOf("setup-notice"), StringComparison.Ordinal);
        Assert.Equal("Recalculate these: 3", here.Shell.Editing.RecalculateText);
        seat.See("setup-recalculate");
        seat.Tap("setup-look").WaitFor(
            () => seat.Find("detail-title") is not null && seat.TextOf("detail-title") == "#2 · 0002",
            "The notice does not lead to the first that waits.");

        double Top() => Math.Round(seat.See("side-machine").TranslatePoint(default, seat.Window)!.Value.Y);
        seat.Tap("nav-system");
        here.Settle();
        Assert.Null(seat.Find("setup-look"));
        seat.Tap("side-machine").Type("edit-compensation.gain", "0.51");
        here.Settle();
        seat.Type("edit-compensation.gain", "0.5");
        here.Shell.Editing.Change("", d => d with { Name = "Complex mating, halved" });
        here.Settle();
        seat.Save().WaitFor(() => seat.Find("setup-notice") is not null, "It is not saved once more.").See("setup-recalculate");
        seat.Window.Height = 720;
        foreach (var side in new[] { "side-coordinates", "side-blocks", "side-tolerances", "side-gauge", "side-machine" })
        {
            seat.Tap(side).See("setup-recalculate");
            BeClean(seat, side == "side-machine" ? "setup-recalculate" : null);
        }

        // Somebody else decides about one of them meanwhile.
        decisions.Reject(3, DemoCell.Operator, "dirty");
        seat.Tap("setup-recalculate").WaitFor(
            () => seat.TextOf("setup-notice")!.StartsWith("Recalculated", StringComparison.Ordinal), "Nothing is said of it.");
        Assert.Equal(
            "Recalculated: 2. #3 · 0003 was not recalculated: This cannot be done in its current state. Look at it again.",
            seat.TextOf("setup-notice"));
        Assert.Null(seat.Find("setup-recalculate"));
        Assert.Equal(5, here.Shell.Editing.FirstWaiting);
        Texts.Current.Language = Language.TraditionalChinese;
        here.Settle();
        Assert.StartsWith("已重新計算：2 件。", seat.TextOf("setup-notice"), StringComparison.Ordinal);
        Texts.Current.Language = Language.English;

        // The notice leads there.
        seat.Tap("setup-look").WaitFor(
            () => seat.Find("detail-title") is not null && seat.TextOf("detail-title") == "#5 · 0002",
            "The notice does not lead to the first of them.");
        Assert.Equal(ScreenKeys.Compensation, seat.Shell.Chosen!.Screen.Key);

        // With half the gain the programs are displaced half as far, in the order in which they stood.
        foreach (var (old, anew) in new[] { (2L, 5L), (4L, 6L) })
        {
            var made = seat.WaitFor(anew, CorrectionState.Proposed);
            var was = store.Find(old)!;
            Assert.Equal((CorrectionState.Superseded, old, was.Serial), (was.State, made.MeasuredAs, made.Serial));
            Assert.InRange(made.LargestMm!.Value / was.LargestMm!.Value, 0.45, 0.55);
        }

        Assert.Equal(CorrectionState.Rejected, store.Find(3)!.State);
        Assert.Equal(CorrectionState.Verified, store.Find(1)!.State);
    });

    [Fact]
    public Task Where_nothing_waits_saving_offers_nothing() => SetupSeat.AtAsync("system", here =>
    {
        here.Seat.Tap("side-machine").Type("edit-compensation.gain", "0.5");
        here.Settle();
        here.Seat.Save().WaitFor(() => here.Seat.Find("setup-notice") is not null, "It is not saved.");
        Assert.Equal("Saved: the next part uses it.", here.TextOf("setup-notice"));
        Assert.Null(here.Seat.Find("setup-recalculate"));
        Assert.Null(here.Seat.Find("setup-look"));
    });

    // In both languages.
    private static void BeClean(Seat seat, string? picture = null)
    {
        foreach (var language in new[] { Language.TraditionalChinese, Language.English })
        {
            Texts.Current.Language = language;
            seat.User.Settle();
            Assert.Empty(Layout.Problems(seat.Window));
            if (picture is not null)
            {
                seat.User.Screenshot(Repository.PathTo(
                    "artifacts", "screenshots", $"{picture}-{(language == Language.English ? "en" : "zh")}.png"));
            }
        }
    }

    private static RowList<ListedCorrection> Rows(Seat seat) => ((CompensationViewModel)seat.Shell.Current!).Rows;

    private static void Change(Seat seat, string was, string now)
    {
        var file = Path.Combine(Path.GetDirectoryName(seat.Station.Settings.Jobs[0].File)!, "theoretical.csv");
        var text = File.ReadAllText(file);
        var changed = text.Replace(was, now, StringComparison.Ordinal);
        Assert.NotEqual(text, changed);
        File.WriteAllText(file, changed);
    }
}
