using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What is wrong and what is still to be filled in is counted where one looks for it, and the counts lead to it.</summary>
public sealed class SetupCountTests
{
    private static readonly string[] Sides = ["coordinates", "blocks", "tolerances", "machine", "gauge"];

    [Fact]
    public Task Each_side_says_how_much_is_to_be_corrected_on_it_and_saving_looks_ready_once_nothing_is() => At(seat =>
    {
        var save = seat.Seat.See("setup-save");
        seat.Shell.Editing.Change(
            "",
            d => (d with { Name = "" })
                .With("$.toleranceChain[0].name", "cover")
                .With("$.toleranceChain[0].nominalMm", "15")
                .With("$.toleranceChain[0].toleranceMm[0]", "0.02")
                .With("$.toleranceChain[0].toleranceMm[1]", "x")
                .With("$.toleranceChain[0].sign", "-1")
                .With("$.counterpart.frame.rotateDeg", "x"));
        seat.Settle();
        var place = seat.Shell.Editing.Problems.Select(p => ProblemPlace.Of(seat.Draft, p.Field)).ToArray();
        Assert.Contains(place, p => p.ScreenKey == ScreenKeys.Points);
        for (var side = 0; side < Sides.Length; side++)
        {
            var count = place.Count(p => p == new ProblemPlace(ScreenKeys.System, side));
            Assert.Equal(side is ProblemPlace.Tolerances or ProblemPlace.Machine ? 1 : 0, count);
            var head = seat.Seat.See("side-" + Sides[side]);
            Assert.Equal(count > 0 ? $"To correct: {count}" : null, AutomationProperties.GetHelpText(head));
            Assert.Equal(
                count > 0,
                head.GetVisualDescendants()
                    .OfType<Avalonia.Controls.Shapes.Path>()
                    .Any(p => p.IsEffectivelyVisible && p.Classes.Contains("alarm")));
        }

        Assert.True(save.IsEffectivelyEnabled);
        Assert.DoesNotContain("accent", save.Classes);
        seat.Shell.Editing.DiscardChanges.Execute(null);
        seat.Shell.Editing.Change("", d => d with { Name = "Again" });
        seat.Settle();
        Assert.True(save.IsEffectivelyEnabled);
        Assert.Contains("accent", save.Classes);

        // The sample's points 2 and 4 lie on corners, which is asked about and saved all the same.
        Assert.Equal(["To check: 2", null, null, null, null], seat.System.Heads.Select(h => h.Problem));
    });

    [Fact]
    public Task The_count_looks_like_a_button_only_where_it_leads_to_something() => At(seat =>
    {
        var count = (Button)seat.Seat.See("setup-problems");

        // The sample's points 2 and 4 lie on corners: one tap leads to the first, from whichever side.
        Assert.Equal((true, "To check: 2", Color("Attention")), (count.IsEffectivelyEnabled, AutomationProperties.GetName(count), Words()));
        seat.Seat.Tap("side-machine")
            .Tap("setup-problems")
            .WaitFor(() => seat.Seat.Find("edit-features[0].points[1]") is { IsFocused: true }, "The point on a corner has no focus.");
        seat.Seat.Type("edit-features[0].points[1]/y", "59.846")
            .Type("edit-features[1].points[1][1]/y", "39.5")
            .Type("edit-features[1].points[1][1]/x", "-34.5");
        seat.Settle();
        Assert.Equal(
            (false, "All filled in", Color("Line"), Color("InkQuiet")),
            (count.IsEffectivelyEnabled, AutomationProperties.GetName(count), Border(), Words()));
        seat.Seat.Tap("setup-anew");
        seat.Settle();
        Assert.Equal((true, Color("Accent"), Color("Accent")), (count.IsEffectivelyEnabled, Border(), Words()));

        // What is wrong stays red.
        seat.Shell.Editing.Change("", d => d.With("$.counterpart.frame.rotateDeg", "x"));
        seat.Settle();
        Assert.Equal(
            Color("Alarm"),
            (
                (Avalonia.Media.ISolidColorBrush)count.GetVisualDescendants()
                    .OfType<TextBlock>()
                    .Single(t => t.IsEffectivelyVisible && t.Text!.StartsWith("To correct", StringComparison.Ordinal)).Foreground!).Color);

        Avalonia.Media.Color Border() =>
            (
                (Avalonia.Media.ISolidColorBrush)count.GetVisualDescendants()
                    .OfType<Avalonia.Controls.Presenters.ContentPresenter>()
                    .First().BorderBrush!).Color;
        Avalonia.Media.Color Words() =>
            (
                (Avalonia.Media.ISolidColorBrush)count.GetVisualDescendants()
                    .OfType<TextBlock>()
                    .First(t => t.IsEffectivelyVisible).Foreground!).Color;
        Avalonia.Media.Color Color(string key) =>
            ((Avalonia.Media.ISolidColorBrush)seat.Seat.Window.FindResource(seat.Seat.Window.ActualThemeVariant, key)!).Color;
    });

    [Fact]
    public Task Points_on_corners_are_asked_about_before_the_job_is_saved_on_whichever_side_one_is() => At(seat =>
    {
        const string Corners = "On rounded corners, not fully compensated: 2 (1.5\u00a0mm), 4 (1.4\u00a0mm). Better that much further "
            + "from the corner; you can save it as it is.";
        Assert.Equal(Corners, seat.TextOf("points-corners"));
        Assert.Contains("asked", seat.Seat.See("edit-features[0].points[1]").Classes);
        Assert.DoesNotContain("asked", seat.Seat.See("edit-features[0].points[0]").Classes);
        Assert.Equal(
            "On a rounded corner, a point says something about both elements together, so each is less certain. Probe it at least 1.5 mm "
                + "further from the corner.",
            AutomationProperties.GetHelpText(seat.Seat.See("edit-features[0].points[1]")));
        Assert.Equal("To check: 2", AutomationProperties.GetHelpText(seat.Seat.See("side-coordinates")));
        BothLanguages.Take(seat.Seat, "system-corners");

        // So much further away, along L1, it is asked about no more; the job could have been saved with it.
        Assert.Empty(seat.Shell.Editing.Problems);
        seat.Seat.Type("edit-features[0].points[1]/y", "59.846");
        seat.Settle();
        Assert.Equal(Corners.Replace("2 (1.5\u00a0mm), ", "", StringComparison.Ordinal), seat.TextOf("points-corners"));
        Assert.Equal("To check: 1", seat.System.Heads[0].Problem);
        Assert.True(seat.Seat.See("setup-save").IsEffectivelyEnabled);
    });

    [Fact]
    public Task What_is_still_to_be_filled_in_is_told_quietly_and_what_is_wrong_aloud() => At(seat =>
    {
        seat.Seat.Tap("setup-anew");
        seat.Shell.Editing.Change(
            "", d => d with { Name = "Piece", Features = [FeatureDraft.New(ErrorMatching.Mating.LineKind.Instance, "L1", d)] });
        seat.Settle();

        // Four coordinates, the program and blocks, two limits, the tool, the uncertainty.
        Assert.Equal((0, 10, "To fill in: 10"), (seat.Shell.Editing.WrongCount, seat.Shell.Editing.MissingCount, seat.System.ProblemCount));
        seat.Seat.Tap("setup-problems");
        seat.Seat.WaitFor(() => seat.Seat.Find("edit-features[0].points[0]/x") is { IsFocused: true }, "The coordinate has no focus.");
        Assert.Equal("Fill this in.", seat.TextOf("problem-features[0].points[0]/x"));
        Assert.DoesNotContain("wrong", seat.Seat.See("edit-features[0].points[0]/x").Classes);
        Assert.DoesNotContain("alarm", seat.Seat.See("problem-features[0].points[0]/x").Classes);
        Assert.Equal(
            ["To fill in: 4", "To fill in: 2", "To fill in: 2", "To fill in: 1", "To fill in: 1"],
            seat.System.Heads.Select(h => h.Problem));
        seat.Seat.Type("edit-features[0].points[0]/x", "abc");
        seat.Settle();
        Assert.Equal(
            ("To correct: 1 · To fill in: 9", "To correct: 1 · To fill in: 3"), (seat.System.ProblemCount, seat.System.Heads[0].Problem));
        Assert.Contains("wrong", seat.Seat.See("edit-features[0].points[0]/x").Classes);
        Assert.Contains("alarm", seat.Seat.See("problem-features[0].points[0]/x").Classes);
    });

    [Fact]
    public Task The_count_and_saving_lead_to_the_first_in_the_order_in_which_one_reads() => At(seat =>
    {
        // In the job the gauge stands before the tool, and what is typed wrong after what is empty.
        seat.Shell.Editing.Change(
            "",
            d => (
                d.With("$.gauge.uncertaintyMm", "x").With("$.counterpart.toolDiameterMm", "").With("$.counterpart.frame.rotateDeg", "y"))
                .WithFeature(1, f => f with { Lower = "z" }));
        seat.Settle();
        foreach (var (id, side, text) in new[]
        {
            ("edit-features[1].toleranceMm[0]", ProblemPlace.Tolerances, "-0.05"),
            ("edit-counterpart.toolDiameterMm", ProblemPlace.Machine, "6"),
            ("edit-counterpart.frame.rotateDeg", ProblemPlace.Machine, "0")
        })
        {
            seat.Seat.Tap(text == "6" ? "setup-save" : "setup-problems");
            seat.Seat.WaitFor(() => seat.Seat.Find(id) is { IsFocused: true }, $"{id} has no focus.");
            Assert.Equal(side, seat.System.Side);
            Assert.Equal(
                text == "6" ? "Not saved: 2 to correct in System set-up, 1 to fill in System set-up." : null, seat.Shell.Editing.Notice);
            seat.Seat.Type(id, text);
            seat.Settle();
        }

        // What is on the other screen comes before, and why nothing is saved is still said there.
        seat.Shell.Editing.Change("", d => d with { Name = "" });
        seat.Settle();
        seat.Seat.Tap("setup-save");
        seat.Seat.WaitFor(() => seat.Seat.Find("edit-name") is { IsFocused: true }, "The name has no focus.");
        Assert.Equal("Not saved: 1 to correct in System set-up, 1 to fill in Point set-up.", seat.TextOf("setup-notice"));
    });

    [Fact]
    public Task The_count_of_a_screen_is_its_own_and_grows_by_nothing_that_is_to_be_filled_in_on_the_other() =>
        SetupSeat.AtAsync(ScreenKeys.Points, seat =>
    {
        // Name and features here; the program, the tool and the uncertainty are the next step's.
        seat.Seat.Tap("setup-anew");
        Assert.Equal("To fill in: 2", seat.Settle().Setup.ProblemCount);
        seat.Seat.Tap("add-line").Tap("add-triangle").Tap("add-curve");
        Assert.Equal("To fill in: 1", seat.Settle().Setup.ProblemCount);
        seat.Seat.Type("edit-name", "Piece");
        seat.Settle();
        var step = (Button)seat.Seat.See("setup-step");
        Assert.Equal(("All filled in", 30), (seat.Setup.ProblemCount, seat.Shell.Editing.MissingCount));
        Assert.Equal("Next: 30 to fill in System set-up", AutomationProperties.GetName(step));
        Assert.Contains("accent", step.Classes);
        Assert.False(seat.Seat.See("setup-problems").IsEffectivelyEnabled);

        // Nine points, program and blocks of three, limits of three, tool, uncertainty: 18 + 4 + 6 + 2.
        seat.Seat.Tap("setup-step");
        seat.Settle();
        Assert.Equal(("To fill in: 30", "Back: Point set-up"), (seat.System.ProblemCount, seat.System.StepText));
        Assert.DoesNotContain("accent", seat.Seat.See("setup-step").Classes);
    });

    [Fact]
    public Task Each_step_leads_to_the_other() => At(seat =>
    {
        seat.Seat.Tap("setup-step");
        Assert.Equal(ScreenKeys.Points, seat.Shell.Chosen!.Screen.Key);
        Assert.Equal("Next: System set-up", seat.Setup.StepText);

        // A tap right behind the first would be taken for its second half (TapTests).
        seat.Seat.User.Wait(TimeSpan.FromMilliseconds(600));
        seat.Seat.Tap("setup-step");
        Assert.Equal((ScreenKeys.System, "Back: Point set-up"), (seat.Shell.Chosen!.Screen.Key, seat.System.StepText));
    });

    [Fact]
    public Task The_count_and_saving_lead_to_the_first_mistake_on_whichever_screen() => At(seat =>
    {
        seat.Shell.Editing.Change("", d => d.WithFeature(2, f => f with { Name = "" }));
        seat.Settle();
        Assert.Equal(("All filled in", "Back: 1 to fill in Point set-up"), (seat.System.ProblemCount, seat.System.StepText));
        seat.Seat.Tap("setup-save");
        seat.Seat.WaitFor(() => seat.Seat.Find("edit-features[2].name") is { IsFocused: true }, "The name has no focus.");
        Assert.Equal(ScreenKeys.Points, seat.Shell.Chosen!.Screen.Key);
        seat.Seat.Type("edit-features[2].name", "C1");
        seat.Shell.Editing.Change("", d => d.With("$.counterpart.frame.rotateDeg", "x"));
        seat.Settle();
        seat.Seat.Tap("setup-problems");
        seat.Seat.WaitFor(() => seat.Seat.Find("edit-counterpart.frame.rotateDeg") is { IsFocused: true }, "The rotation has no focus.");
        Assert.Equal(ScreenKeys.System, seat.Shell.Chosen!.Screen.Key);
    });

    private static Task At(Action<SetupSeat> test, string user = DemoCell.Setter) => SetupSeat.AtAsync(ScreenKeys.System, test, user);
}
