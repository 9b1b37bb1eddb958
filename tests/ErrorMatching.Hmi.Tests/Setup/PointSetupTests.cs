using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Features and points are counted on the screen, back and forth.</summary>
public sealed class PointSetupTests
{
    [Fact]
    public Task A_job_is_shown_as_it_stands() => At(seat =>
    {
        Assert.Equal("In use at vmc1, slot A.", seat.TextOf("setup-state"));
        Assert.Equal(
            ("WO-2021-02", "Complex mating", "anna"),
            (seat.Setup.WorkOrder.Text, seat.Setup.Workpiece.Text, seat.Seat.TextOf("points-operator")));
        Assert.Equal(
            [("L1", "2"), ("L2L3", "2 2"), ("C1", "10")],
            seat.Setup.Features.Select(f => (f.Name.Text, string.Join(' ', f.Flanks.Select(k => k.Count.Text)))));
        Assert.Equal((false, 16, 16), (seat.Setup.Drawing.IsSchematic, seat.Setup.Drawing.Known, seat.Setup.Drawing.Total));

        // The first point under the finger: the sample's own place.
        var plot = (PartPlot)seat.Seat.See("points-drawing");
        Assert.Empty(plot.LeftOut);
        var first = plot.View.ToScreen(new(-31.95, 76.008));
        seat.Seat.User.Click(plot, new(first.X + 3, first.Y - 2));
        Assert.Equal("1  x −31.9500  y 76.0080 mm", plot.Values);
    });

    [Fact]
    public Task A_code_that_is_scanned_is_the_work_order() => At(seat =>
    {
        seat.Seat.See("nav-points").Focus();
        seat.Seat.User.Type("WO-4711").Press(Key.Enter);
        Assert.Equal("WO-4711", seat.Draft["$.workOrder"]);
    });

    [Fact]
    public Task A_count_that_is_none_is_said_at_its_field_and_is_not_saved() => At(seat =>
    {
        var count = seat.Setup.Features[2].Flanks[0].Count;
        seat.Seat.Type(count.AutomationId, "1o").User.Press(Key.Tab);
        seat.Settle();
        Assert.Equal("Enter a whole number up to 1000.", seat.Seat.TextOf(count.ProblemId));
        Assert.Equal(("1o", 10, "To correct: 1"), (count.Text, seat.Draft.Features[2].Flanks[0].Count, seat.Setup.ProblemCount));

        // The next change puts the old value back.
        seat.Seat.Type(seat.Setup.WorkOrder.AutomationId, "WO-1");
        seat.Settle();
        Assert.Equal(("10", "To check: 2"), (count.Text, seat.Setup.ProblemCount));
        seat.Seat.Type(count.AutomationId, "-3").User.Press(Key.Tab);
        seat.Seat.Tap("setup-save");
        seat.Settle();
        Assert.True(seat.Shell.Editing.IsChanged);
        seat.Seat.Type(count.AutomationId, "9").User.Press(Key.Tab);
        Assert.Equal((9, (DraftProblem?)null), (seat.Draft.Features[2].Flanks[0].Count, seat.Shell.Editing.Typed));
    });

    [Fact]
    public Task A_new_job_says_for_which_place_it_is_and_that_the_one_there_runs_until_it_is_put_in_use() => At(seat =>
    {
        var anew = seat.Seat.See("setup-anew");
        Assert.Equal(
            "A new job from an empty form, for vmc1, slot A. It is saved under its own name; complex-mating runs until you put the new "
                + "one in use.",
            AutomationProperties.GetHelpText(anew));
        Assert.Equal(AutomationProperties.GetHelpText(anew), ToolTip.GetTip(anew));
        seat.Seat.Tap("setup-anew");
        seat.Settle();
        var state = (TextBlock)seat.Seat.See("setup-state");
        Assert.Equal("Not saved: complex-mating still runs at vmc1, slot A.", state.Text);
        Assert.Single(state.TextLayout.TextLines);

        // It is filled in from its beginning.
        seat.Seat.WaitFor(() => seat.Seat.Find("edit-workOrder") is { IsFocused: true }, "The first field has no focus.");
    });

    [Fact]
    public Task A_file_of_several_jobs_is_listed_once_and_changes_that_were_kept_for_another_of_them_are_found()
    {
        return Seat.AtAsync(seat =>
        {
            // The demonstration's parts and counterparts have one file.
            var jobs = seat.Station.Settings.Jobs.Where(j => !j.IsFreeform).ToArray();
            Assert.Equal(["complex-mating", "counterparts"], jobs.Select(j => j.Name));
            Assert.Single(jobs.Select(j => j.File).Distinct());
            new DraftFolder(Path.Combine(Path.GetDirectoryName(seat.Station.Settings.File)!, "drafts"))
                .Keep(
                    new()
                    {
                        Job = "counterparts",
                        By = "anna",
                        At = DateTimeOffset.UnixEpoch,
                        BaseSha256 = JobEdits.Sha256Of(jobs[1]),
                        Draft = MatingDraftFiles.Open(jobs[1].File) with { Name = "Stored" }
                    });
            seat.SignIn(DemoCell.Setter).Tap("nav-points");
            var here = new SetupSeat(seat).Settle();
            Assert.Equal(["complex-mating"], here.Shell.Editing.Jobs.Select(j => j.Name));
            seat.Tap("setup-kept-continue");
            Assert.Equal("Stored", here.Settle().Draft.Name);
            here.Shell.Editing.Choose(jobs[1]);
            Assert.Equal("complex-mating", here.Shell.Editing.Job!.Name);
            seat.Tap("setup-discard");
            here.Settle();
            Assert.Empty(Directory.GetFiles(Path.Combine(Path.GetDirectoryName(seat.Station.Settings.File)!, "drafts")));
        });
    }

    [Fact]
    public Task Features_and_points_come_and_go_and_come_back() => At(seat =>
    {
        seat.Seat.Tap("setup-anew");
        Assert.Empty(seat.Setup.Features);
        seat.Seat.Tap("add-line").Tap("add-triangle").Tap("add-curve");
        Assert.Equal(["1", "2", "3", "4", "5", "6", "7", "8", "9"], seat.Draft.Points.Select(p => p.Label));
        Assert.True(seat.Setup.Drawing.IsSchematic);
        Assert.Equal("Schematic: 9 points, none with coordinates yet.", seat.Seat.TextOf("points-caption"));
        seat.Seat.Tap("feature-1-flank-1-more")
            .Tap("feature-1-flank-0-less")
            .Type("edit-features[2].points", "10")
            .Type("edit-features[0].name", "Front");
        Assert.Equal(["2", "1 3", "10"], seat.Draft.Features.Select(f => string.Join(' ', f.Flanks.Select(k => k.Count))));
        Assert.Equal(["Front", "T1", "C1"], seat.Draft.Features.Select(f => f.Name));
        Assert.Equal(seat.Draft.Points.Count(), seat.Draft.Points.Select(p => p.Label).Distinct().Count());
        seat.Seat.Tap("feature-2-up");
        Assert.Equal(["Front", "C1", "T1"], seat.Draft.Features.Select(f => f.Name));
        seat.Seat.Tap("feature-0-remove");
        Assert.Equal(["C1", "T1"], seat.Draft.Features.Select(f => f.Name));
        for (var i = 0; i < 20 && seat.Shell.Editing.Undo.CanExecute(null); i++)
        {
            seat.Seat.User.Press(Key.Z, RawInputModifiers.Control);
        }

        Assert.Equal(["L1", "L2L3", "C1"], seat.Draft.Features.Select(f => f.Name));
        Assert.False(seat.Shell.Editing.IsChanged);
        for (var i = 0; i < 20 && seat.Shell.Editing.Redo.CanExecute(null); i++)
        {
            seat.Seat.Tap("setup-redo");
        }

        Assert.Equal(["C1", "T1"], seat.Draft.Features.Select(f => f.Name));
    });

    [Fact]
    public Task What_is_typed_into_one_field_is_one_step() => At(seat =>
    {
        seat.Seat.Type("edit-name", "Housing").Type("edit-workOrder", "WO-7");
        Assert.Equal(("Housing", "WO-7"), (seat.Draft.Name, seat.Draft["$.workOrder"]));
        seat.Seat.Tap("setup-undo");
        Assert.Equal(("Housing", "WO-2021-02"), (seat.Draft.Name, seat.Draft["$.workOrder"]));
        seat.Seat.User.Press(Key.Z, RawInputModifiers.Control);
        Assert.Equal(("Complex mating", "WO-2021-02"), (seat.Draft.Name, seat.Draft["$.workOrder"]));
        Assert.Equal("Complex mating", seat.Setup.Workpiece.Text);
        seat.Seat.User.Press(Key.Y, RawInputModifiers.Control);
        Assert.Equal("Housing", seat.Draft.Name);
    });

    [Fact]
    public Task An_operator_sees_everything_and_changes_nothing() => At(
        seat =>
        {
            Assert.Equal(
                "Only setters and administrators can change jobs. You can view everything here.", seat.Seat.TextOf("setup-forbidden"));
            Assert.All(
                new[] { "setup-save", "setup-anew", "add-line", "edit-name", "feature-0-remove", "feature-0-flank-0-more" },
                id => Assert.False(seat.Seat.See(id).IsEffectivelyEnabled, id));
            seat.Seat.Type("edit-name", "Mine");
            seat.Shell.Editing.Change("", d => d with { Name = "Mine" });
            Assert.Equal("Complex mating", seat.Draft.Name);
            Assert.Equal(3, seat.Setup.Features.Count);
        },
        DemoCell.Operator);

    [Fact]
    public Task Counts_and_names_that_are_wrong_are_told_there() => At(seat =>
    {
        seat.Seat.Type("edit-features[0].points", "1").Type("edit-features[2].name", "L1");
        seat.Settle();
        Assert.Equal("This name is already used.", seat.Seat.TextOf("problem-features[2].name"));
        _ = seat.Seat.See("edit-features[0].points").Focus();
        seat.Settle();
        Assert.StartsWith("Too few points", seat.Seat.TextOf("problem-features[0].points"), StringComparison.Ordinal);
        seat.Seat.Tap("edit-name").Type("edit-name", " ");
        seat.Settle();
        Assert.Equal("Fill this in.", seat.Seat.TextOf("problem-name"));
        Assert.Null(seat.Seat.Find("problem-workOrder"));
    });

    [Fact]
    public void A_drawing_grows_with_each_entry()
    {
        var draft = new MatingDraft();
        draft = draft with { Features = [FeatureDraft.New(LineKind.Instance, "L", draft)] };
        draft = draft with { Features = [.. draft.Features, FeatureDraft.New(TriangleKind.Instance, "T", draft)] };
        var schematic = PartDrawing.Of(draft);
        Assert.Equal((true, 0, 6), (schematic.IsSchematic, schematic.Known, schematic.Total));
        Assert.Equal(6, schematic.Lines.SelectMany(l => l.Points).Select(p => p.At).Distinct().Count());
        var known = PartDrawing.Of(draft.WithFeature(
            1, f => f with { Flanks = f.Flanks.Replaced(0, f.Flanks[0].Replaced(1, new("4", "-1.5", "2e1"))) }));
        Assert.Equal((false, 1, 6), (known.IsSchematic, known.Known, known.Total));
        Assert.Equal(("4", new Geometry.Point2(-1.5, 20)), Assert.Single(known.Lines.SelectMany(l => l.Points)));
    }

    [Fact]
    public void A_triangle_is_drawn_over_the_apex_that_nobody_measures()
    {
        var draft = new MatingDraft();
        draft = draft with { Features = [FeatureDraft.New(TriangleKind.Instance, "T", draft)] };
        var schematic = PartDrawing.Of(draft).Lines[0];
        Assert.Equal(5, schematic.Outline.Count);
        Assert.True(schematic.Outline[2].Y < schematic.Points.Min(p => p.At.Y) - 1, "It has a flat bottom.");

        // Down to the right and up again: the flanks meet at (4, -4).
        Assert.Equal(0, Outline(("0", "0"), ("1", "-1"), ("6", "-2"), ("8", "0"))[2].DistanceTo(new(4, -4)), 1e-9);

        // Parallel flanks, flanks that do not lead to where they meet, and a missing point have no apex.
        Assert.Equal(4, Outline(("0", "0"), ("1", "-1"), ("6", "0"), ("7", "-1")).Count);
        Assert.Equal(4, Outline(("1", "-1"), ("0", "0"), ("6", "-2"), ("8", "0")).Count);
        Assert.Equal(3, Outline(("0", "0"), ("1", "-1"), ("6", "-2"), ("8", "")).Count);

        IReadOnlyList<Geometry.Point2> Outline(params (string X, string Y)[] at) => PartDrawing.Of(draft.WithFeature(0, f => f with
        {
            Flanks = [[new("1", at[0].X, at[0].Y), new("2", at[1].X, at[1].Y)], [new("3", at[2].X, at[2].Y), new("4", at[3].X, at[3].Y)]],
        })).Lines[0].Outline;
    }

    [Fact]
    public void A_curve_without_coordinates_is_round_and_passes_through_its_points()
    {
        var draft = new MatingDraft();
        draft = draft with { Features = [FeatureDraft.New(CurveKind.Instance, "C", draft)] };
        var curve = PartDrawing.Of(draft.WithFeature(
            0, f => f with { Flanks = [[new("1", "", ""), new("2", "", ""), new("3", "", "")]] })).Lines[0];
        Assert.Equal(["1", "2", "3"], curve.Points.Select(p => p.Label));
        Assert.All(curve.Points, p => Assert.Contains(curve.Outline, o => o.DistanceTo(p.At) < 1e-9));

        // Halfway to its top it lies well above the chord, as the side of a triangle would not.
        var halfway = curve.Outline.MinBy(o => Math.Abs(o.X - ((curve.Points[0].At.X + curve.Points[1].At.X) / 2)));
        Assert.True(halfway.Y > 0.6 * curve.Points[1].At.Y, $"It is {halfway.Y} high.");
    }

    [Fact]
    public Task It_looks_right() => At(seat =>
    {
        var pictures = new Pictures(seat.Seat.RunCell());
        pictures.Take("points");
        seat.Seat.Tap("setup-anew").Tap("add-line").Tap("add-triangle").Tap("add-curve").Tap("setup-problems");
        seat.Settle();
        pictures.Take("points-anew", isPictured: false);
        pictures.MustBeClean();
    });

    private static Task At(Action<SetupSeat> test, string user = DemoCell.Setter) => SetupSeat.AtAsync(ScreenKeys.Points, test, user);
}
