using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Coordinates, blocks and limits are entered on the screen; what is wrong is told there, and nothing wrong is saved.</summary>
public sealed class SystemSetupTests
{
    private static readonly string[] Sides = ["coordinates", "blocks", "tolerances", "machine", "gauge"];

    // What is typed where, on which side, and what is told where.
    public static TheoryData<string, string, string, string, string> Mistakes => new()
    {
        { "coordinates", "edit-features[0].points[1]/y", "", "problem-features[0].points[1]/y", "Fill this in." },
        { "coordinates", "edit-features[0].points[0]/x", "abc", "problem-features[0].points[0]/x", "Enter a number" },
        { "blocks", "edit-features[0].blocks", "N121", "problem-features[0].blocks", "The program has no such block" },
        {
            "tolerances",
            "edit-features[0].toleranceMm[0]",
            "0.06",
            "problem-features[0].toleranceMm[0]",
            "The lower limit is above the upper one."
        },
        { "tolerances", "edit-features[0].toleranceMm[1]", "x", "problem-features[0].toleranceMm[1]", "Enter a number" },
        { "machine", "edit-counterpart.frame.translateMm[0]", "", "problem-counterpart.frame.translateMm[0]", "Fill this in." },
        { "machine", "edit-originCheck.point", "O", "problem-originCheck.limitMm", "Fill this in." },
        { "gauge", "edit-gauge.uncertaintyMm", "", "problem-gauge.uncertaintyMm", "Fill this in." },
        { "gauge", "edit-verify[1].points", "99", "problem-verify[1].points", "No feature has this point." },
    };

    [Fact]
    public Task Each_mistake_is_told_at_its_field_and_keeps_the_job_from_being_saved() => At(seat =>
    {
        var (job, seen) = (File.ReadAllBytes(seat.JobFile), new HashSet<string>());
        foreach (var row in Mistakes)
        {
            var (side, field, text, problem, told) = row.Data;
            ((TextField)seat.System.FieldOf(field)).Text = text;
            seat.Settle();
            seat.Shell.Editing.Save.Execute(null);
            seat.Seat.WaitFor(() => !seat.Shell.Editing.Save.IsRunning, "Saving does not end.");
            var at = problem.Replace("problem-", "edit-", StringComparison.Ordinal);
            Assert.StartsWith(told, seat.System.FieldOf(at).Problem, StringComparison.Ordinal);
            if (seen.Add(side))
            {
                // What the field says is on the screen, and the focus is there.
                Assert.StartsWith(told, seat.TextOf(problem), StringComparison.Ordinal);
                seat.Seat.WaitFor(() => seat.Seat.Find(at) is { IsFocused: true }, $"{at} has no focus.");
            }

            seat.Shell.Editing.DiscardChanges.Execute(null);
            seat.Settle();
            Assert.Empty(seat.Shell.Editing.Problems);
        }

        Assert.Equal(Sides.Length, seen.Count);
        Assert.Equal(job, File.ReadAllBytes(seat.JobFile));
    });

    [Fact]
    public Task Limits_the_wrong_way_around_are_told_at_once_where_they_stand() => At(seat =>
    {
        seat.Seat.Tap("setup-anew");
        seat.Shell.Editing.Change(
            "",
            d => (d with { Features = [FeatureDraft.New(ErrorMatching.Mating.LineKind.Instance, "L1", d)] })
                .With("$.toleranceChain[0].name", "cover")
                .With("$.toleranceChain[0].nominalMm", "15")
                .With("$.toleranceChain[0].toleranceMm[0]", "0.1")
                .With("$.toleranceChain[0].toleranceMm[1]", "-0.1"));
        seat.Seat.Tap("side-tolerances").Type("edit-features[0].toleranceMm[0]", "0.05").Type("edit-features[0].toleranceMm[1]", "-0.05");
        seat.Settle();
        Assert.Equal("The lower limit is above the upper one.", seat.TextOf("problem-features[0].toleranceMm[0]"));
        Assert.Contains("wrong", seat.Seat.See("edit-features[0].toleranceMm[0]").Classes);
        _ = seat.Seat.See("edit-toleranceChain[0].toleranceMm[0]").Focus();
        seat.Settle();
        Assert.Equal(
            ("cover · Lower, mm", "The lower limit is above the upper one."),
            (seat.TextOf("setup-told"), seat.TextOf("problem-toleranceChain[0].toleranceMm[0]")));

        // Limits that are not used are not judged.
        seat.Shell.Editing.Change("", d => d.WithFeature(0, f => f with { Tolerance = "chain:rss" }));
        seat.Settle();
        Assert.DoesNotContain(seat.Shell.Editing.Problems, p => p.Field.StartsWith("$.features[0].toleranceMm[", StringComparison.Ordinal));
    });

    [Fact]
    public Task What_is_saved_is_the_cell_s_next_job_and_stands_in_the_trail() => At(seat =>
    {
        seat.Seat.Tap("side-machine").Type("edit-compensation.gain", "0.5");
        seat.Settle();
        seat.Seat.Save();
        seat.Seat.WaitFor(() => seat.Shell.Editing.Notice is not null, "It is not saved.");
        Assert.StartsWith("Saved", seat.TextOf("setup-notice"), StringComparison.Ordinal);
        Assert.Equal(0.5, InputFile.Job(seat.JobFile).Compensation.Gain);
        var entry = seat.Seat.Station.Store.AuditEntries(0, 1000).Last(e => e.What == JobEdits.Edited);
        Assert.Equal((DemoCell.Setter, "complex-mating"), (entry.Who, entry.Subject));
        Assert.Contains(JobEdits.Sha256Of(seat.Shell.Editing.Job!), entry.Basis.Sentence, StringComparison.Ordinal);
        seat.Seat.Cell.Run();
        seat.Seat.Cell.Deliver(1, 0);
        seat.Seat.WaitFor(1, CorrectionState.Proposed);
        using var report = System.Text.Json.JsonDocument.Parse(
            seat.Seat.Station.Store.Content(seat.Seat.Station.Store.Find(1)!.ReportSha256!));
        Assert.Equal(0.5, report.RootElement.GetProperty("compensation").GetProperty("gain").GetDouble());
    });

    [Fact]
    public Task A_job_that_somebody_else_changed_is_not_overwritten() => At(seat =>
    {
        seat.Seat.Tap("side-machine").Type("edit-compensation.gain", "0.5");
        File.AppendAllText(seat.JobFile, "\n");
        var job = File.ReadAllBytes(seat.JobFile);
        seat.Settle();
        seat.Seat.Save();
        seat.Seat.WaitFor(() => seat.Shell.Editing.Message is not null, "Nothing is said.");
        Assert.StartsWith("Someone else changed this job", seat.TextOf("setup-message"), StringComparison.Ordinal);
        Assert.Equal(job, File.ReadAllBytes(seat.JobFile));
    });

    [Fact]
    public Task An_operator_cannot_save_by_any_way() => Seat.AtAsync(seat =>
    {
        var job = seat.Station.Settings.Jobs[0];
        var draft = MatingDraftFiles.Open(job.File) with { Name = "Mine" };
        var by = seat.Station.Users.SignIn(DemoCell.Operator, DemoCell.Password);
        var error = Assert.Throws<PeopleException>(
            () => new JobEdits(seat.Station.Settings, seat.Station.Store, seat.Station.Users).Save(job, draft, JobEdits.Sha256Of(job), by));
        Assert.Equal(PeopleError.NotAllowed, error.Error);
        Assert.Equal("Complex mating", InputFile.Job(job.File).Name);
    });

    [Fact]
    public Task A_table_from_a_spreadsheet_fills_the_points() => At(seat =>
    {
        seat.Seat.Tap("points-paste");
        var clipboard = Avalonia.Controls.TopLevel.GetTopLevel(seat.Seat.Window)!.Clipboard!;
        Avalonia.Input.Platform.ClipboardExtensions.SetTextAsync(clipboard, "1\t-31,951\t76\n2\t-32.3\t58\nO\t0\t0\n")
            .GetAwaiter()
            .GetResult();
        seat.Seat.Tap("points-paste");
        seat.Seat.WaitFor(() => seat.Draft.OtherPoints.Any(p => p.Label == "O"), "Nothing is pasted.");
        Assert.Equal(
            ("-31.951", "76", "-32.3"),
            (seat.Draft.Features[0].Flanks[0][0].X, seat.Draft.Features[0].Flanks[0][0].Y, seat.Draft.Features[0].Flanks[0][1].X));
        Assert.Equal("-31.951", ((Avalonia.Controls.TextBox)seat.Seat.See("edit-features[0].points[0]/x")).Text);
        Assert.StartsWith(
            "The table has 3 points. No point had the label O: added at the end", seat.TextOf("setup-notice"), StringComparison.Ordinal);
        Assert.EndsWith(
            "Not in the table: 2a, 3a, 3b, 4, 5, 6, 7, 8, 9, 10, 11, 12 ….", seat.TextOf("setup-notice"), StringComparison.Ordinal);

        // Into a field: a table goes to all, a number to the field.
        Avalonia.Input.Platform.ClipboardExtensions.SetTextAsync(clipboard, "-7.5").GetAwaiter().GetResult();
        seat.Seat.User.Click(seat.Seat.See("edit-features[0].points[0]/y"))
            .Press(Key.A, RawInputModifiers.Control)
            .Press(Key.V, RawInputModifiers.Control);
        seat.Seat.WaitFor(() => seat.Draft.Features[0].Flanks[0][0].Y == "-7.5", "The number is not pasted.");
        seat.Seat.User.Press(Key.Z, RawInputModifiers.Control);
        Assert.Equal("76", seat.Draft.Features[0].Flanks[0][0].Y);
    });

    [Fact]
    public Task Changes_outlive_the_station() => SetupSeat.AtAsync(ScreenKeys.Points, seat =>
    {
        seat.Seat.Type("edit-name", "Stored");
        seat.Shell.Editing.Change("", d => d with { Program = DraftProgram.Of("N10 G0 X0\n"u8.ToArray()) });
        seat.Settle();

        // The next station finds what this one never saved, as after a crash.
        using var next = new Station(seat.Seat.Cell.Settings, seat.Seat.Clock, Station.DefaultIdle);
        using var shell = Screens.ShellOf(next);
        shell.Editing.Choose(shell.Editing.Jobs[0]);
        seat.Seat.WaitFor(() => shell.Editing.Loading.IsCompleted, "It is not opened.");
        Assert.Equal(("anna", "Stored"), (shell.Editing.Stored!.By, shell.Editing.Stored.Draft.Name));
        Assert.Equal("N10 G0 X0\n"u8.ToArray(), shell.Editing.Stored.Draft.Program!.Bytes.ToArray());
        Assert.Equal("Complex mating", shell.Editing.Draft.Name);
        Assert.False(shell.Editing.CanEdit);
    });

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public Task Kept_changes_are_continued_or_discarded(bool isContinued) => Seat.AtAsync(seat =>
    {
        var job = seat.Station.Settings.Jobs[0];
        var drafts = new DraftFolder(Path.Combine(Path.GetDirectoryName(seat.Station.Settings.File)!, "drafts"));
        drafts.Keep(
            new()
            {
                Job = job.Name,
                By = "berta",
                At = seat.Clock.GetUtcNow(),
                BaseSha256 = JobEdits.Sha256Of(job),
                Draft = MatingDraftFiles.Open(job.File) with { Name = "Stored" }
            });
        seat.SignIn(DemoCell.Setter).Tap("nav-points");
        Assert.StartsWith("Unsaved changes by berta", seat.TextOf("setup-kept"), StringComparison.Ordinal);
        seat.Tap(isContinued ? "setup-kept-continue" : "setup-kept-discard");
        seat.WaitFor(() => seat.Find("setup-kept") is null, "They are still asked about.");
        var here = new SetupSeat(seat).Settle();
        Assert.Equal((isContinued ? "Stored" : "Complex mating", isContinued), (here.Draft.Name, here.Shell.Editing.IsChanged));
        Assert.Equal(isContinued, drafts.Find(job.Name) is not null);
        seat.Tap(isContinued ? "setup-discard" : "add-line");
        here.Settle();
        Assert.Equal(!isContinued, drafts.Find(job.Name) is not null);
    });

    [Fact]
    public Task A_dry_run_shows_what_the_cell_would_compute_and_sends_nothing() => At(seat =>
    {
        seat.Seat.Tap("dry-run");
        seat.Seat.WaitFor(() => seat.Seat.Find("setup-message") is not null, "Nothing is said.");
        Assert.StartsWith("No measurement of this job", seat.TextOf("setup-message"), StringComparison.Ordinal);
        seat.Seat.Cell.Run();
        seat.Seat.Cell.Deliver(1, 0);
        var computed = seat.Seat.WaitFor(1, CorrectionState.Proposed);
        var entries = seat.Seat.Station.Store.AuditHead().Seq;
        seat.Seat.Tap("dry-run");
        seat.Seat.WaitFor(() => seat.System.Detail is not null, "Nothing is shown.");
        Assert.Equal("#1 · 0001", seat.TextOf("detail-title"));
        Assert.Null(seat.Seat.Find("tab-course"));
        seat.Seat.Tap("tab-decisions");
        var place = StoredMove.PlaceOf(seat.Seat.Station.Store.Corrections.StepsOf(1))!;
        Assert.Equal(Texts.Current.With("Head.LargestAt", Shown.Mm(computed.LargestMm), place), seat.TextOf("detail-largest"));
        var kept = StoredReport.Read(seat.Seat.Station.Store.Content(computed.ReportSha256!)).Match!;
        Assert.Equal(kept.KeyPoints.Select(p => p.Correction), seat.System.Detail!.Stored.Report!.KeyPoints.Select(p => p.Correction));
        Assert.Equal(
            Lines(seat.Seat.Station.Store.Content(computed.ProgramSha256!)), seat.System.Detail.Stored.Lines!.Select(l => l.Modified));
        seat.Seat.Tap("dry-run-back").Tap("side-machine").Type("edit-compensation.gain", "0.5");
        seat.Settle();
        seat.Seat.Tap("dry-run");
        seat.Seat.WaitFor(() => seat.System.Detail is not null, "Nothing is shown.");
        Assert.All(
            kept.KeyPoints.Zip(seat.System.Detail!.Stored.Report!.KeyPoints),
            p => Assert.Equal(0, ((p.First.Correction * 0.5) - p.Second.Correction).Length, 1e-8));

        seat.Seat.Tap("tab-decisions");

        // On a corner, half the correction is about half the way of the vertex.
        var half = Shown.Mm(0.5 * computed.LargestMm)[..3];
        Assert.StartsWith(
            Texts.Current.With("Head.LargestAt", half, "").Split(half)[0] + half, seat.TextOf("detail-largest"), StringComparison.Ordinal);
        Assert.EndsWith(place, seat.TextOf("detail-largest"), StringComparison.Ordinal);
        Assert.Equal(entries, seat.Seat.Station.Store.AuditHead().Seq);
    });

    [Fact]
    public Task The_path_shows_the_key_points_where_the_frame_puts_them() => At(seat =>
    {
        seat.Seat.Tap("side-blocks");
        seat.Seat.WaitFor(() => seat.System.Picture?.Points.Count == 16, "The points are not drawn.");
        Assert.Equal(
            ("L1", "1", new Geometry.Point2(-31.95, 76.008)),
            seat.System.Picture!.Points[0] is var p ? (p.Feature, p.Label, p.At) : default);
        seat.Shell.Editing.Change(
            "",
            d => (d.WithFeature(0, f => f with { Blocks = "" }) with { Name = "" }).With("$.counterpart.frame.translateMm[0]", "100"));
        seat.Settle();
        seat.Seat.WaitFor(() => seat.System.Picture.Points[0].At == new Geometry.Point2(68.05, 76.008), "They are not moved.");
        seat.Shell.Editing.Change("", d => d.With("$.counterpart.frame.rotateDeg", "x"));
        seat.Settle();
        seat.Seat.WaitFor(() => seat.System.Picture.Points.Count == 0, "They are drawn in a wrong frame.");
    });

    [Fact]
    public Task A_tap_on_the_name_of_a_feature_shows_all_of_it_and_where_that_has_no_room_the_next_one_shows_its_end() => At(seat =>
    {
        seat.Seat.Tap("side-blocks").WaitFor(() => seat.System.Picture?.Points.Count == 16, "The points are not drawn.");
        var (picture, text, path) = (
            seat.System.Picture!, (ProgramText)seat.Seat.See("program-text"), (PathPlot)seat.Seat.See("program-path"));
        seat.Seat.Tap("pick-1").Tap("language").Tap("language");
        Assert.Equal([false, true, false], seat.System.Blocks.Select(b => b.IsPicked));
        seat.Seat.Tap("pick-1");
        Assert.Equal(("L2L3: N130 to N160: 4 lines", true, true), (picture.Chosen, IsSeen("N130"), IsSeen("N160")));
        MustBeDrawn(1);

        // C1 has 103 blocks.
        seat.Seat.Tap("pick-2");
        Assert.Equal("C1: N170 to N1190: 103 lines. Tap its name again for the end.", picture.Chosen);
        Assert.Equal((true, false), (IsSeen("N170"), IsSeen("N1190")));
        MustBeDrawn(2);
        Take();
        seat.Seat.Tap("pick-2");
        Assert.Equal("C1: N170 to N1190: 103 lines. Tap its name again for the beginning.", picture.Chosen);
        Assert.Equal((false, true), (IsSeen("N170"), IsSeen("N1190")));
        Take();

        // Its rows were made anew for another language, twice.
        Assert.Equal((false, true), (IsSeen("N170"), IsSeen("N1190")));
        seat.Seat.Tap("pick-2");
        Assert.True(IsSeen("N170"));

        // Another one between them begins at its beginning; nothing was taken for any of them.
        seat.Seat.Tap("pick-0").Tap("pick-2");
        Assert.Equal((true, "N170..N1190"), (IsSeen("N170"), seat.Draft.Features[2].Blocks));
        Assert.Null(picture.Selection);

        // Rows are made anew in another language: a tap right behind would be taken for the second half of the one before (TapTests).
        void Take()
        {
            BothLanguages.Take(seat.Seat, "system-feature-" + (picture.Look!.IsAtEnd ? "end" : "begin"));
            seat.Seat.User.Wait(TimeSpan.FromMilliseconds(600));
        }

        bool IsSeen(string name)
        {
            var now = (ProgramText)seat.Seat.See("program-text");
            var top = (
                Enumerable.Range(0, picture.Program.Count).First(b => picture.Program.NameOf(b) == name) * now.RowHeight) - now.Offset.Y;
            return top >= 0 && top + now.RowHeight <= now.Bounds.Height;
        }

        // Its points and the ends of its moves stand in the drawing, beside the buttons, and fill it one way or the other.
        void MustBeDrawn(int feature)
        {
            var (mark, buttons) = (picture.Marks[feature], path.GetVisualDescendants().OfType<UniformGrid>().First().Bounds.Left);
            var ends = Enumerable.Range(mark.Ranges[0].First, mark.Ranges[0].Count)
                .Select(picture.Program.Path.MotionOf)
                .Where(m => m >= 0)
                .Select(m => picture.Program.Moves.EndsOf(m)!.Value)
                .SelectMany(e => new[] { e.From, e.To });
            Point[] places = [
                .. ends.Concat(picture.Points.Where(p => p.Feature == mark.Name).Select(p => p.At)).Select(p => path.View.At(p))];
            Assert.All(places, p => Assert.True(p.X >= 0 && p.X <= buttons && p.Y >= 0 && p.Y <= path.Bounds.Height, $"{p} is not seen."));
            Assert.True(
                places.Max(p => p.X) - places.Min(p => p.X) > buttons / 2
                    || places.Max(p => p.Y) - places.Min(p => p.Y) > path.Bounds.Height / 2,
                "It is small.");
        }
    });

    [Fact]
    public Task It_looks_right() => At(seat =>
    {
        var pictures = new Pictures(seat.Seat.RunCell());
        foreach (var side in Sides)
        {
            seat.Seat.Tap("side-" + side);
            pictures.Take("system-" + side, side is "coordinates" or "blocks");
        }

        // A usual block fits beside its path; one that does not stands whole above it.
        seat.Seat.Tap("side-blocks");
        seat.System.Picture!.Light(
            Enumerable.Range(0, seat.System.Picture.Program.Count).First(b => seat.System.Picture.Program.NameOf(b) == "N140"));
        pictures.Take("system-blocks-lit", isPictured: false);
        var text = (ProgramText)seat.Seat.See("program-text");
        Assert.DoesNotContain(seat.System.Picture.Cursor, text.RowsCut);
        Assert.Equal("N140 G3 X-48.334 Y48.745 I2.941 J-5.23", seat.TextOf("program-line"));

        // Blocks that are still to be picked, beside the points that they are to cut.
        seat.Shell.Editing.Change(
            "",
            d => d.WithFeature(0, f => f with { Blocks = "" })
                .WithFeature(1, f => f with { Blocks = "" })
                .WithFeature(2, f => f with { Blocks = "" }));
        seat.Settle();
        pictures.Take("system-blocks-anew", isPictured: false);
        seat.Shell.Editing.DiscardChanges.Execute(null);
        seat.Settle();

        seat.Shell.Editing.Change(
            "",
            d => d.With("$.toleranceChain[0].name", "housing")
                .With("$.toleranceChain[0].nominalMm", "17.5")
                .With("$.toleranceChain[0].toleranceMm[0]", "-0.03")
                .With("$.toleranceChain[0].toleranceMm[1]", "0.03")
                .With("$.toleranceChain[1].name", "cover")
                .With("$.toleranceChain[1].nominalMm", "15")
                .With("$.toleranceChain[1].toleranceMm[0]", "0.02")
                .With("$.toleranceChain[1].toleranceMm[1]", "x")
                .With("$.toleranceChain[1].sign", "-1")
                .With("$.alignment.kind", "best-fit")
                .With("$.compensation.from", "counterpart"));
        seat.Settle();
        foreach (var side in Sides)
        {
            seat.Seat.Tap("side-" + side);
            pictures.Take("system-wrong-" + side, isPictured: false);
        }

        // With the field that is to be corrected in sight, and what is wrong with it above.
        seat.Seat.Tap("side-coordinates")
            .Tap("setup-problems")
            .WaitFor(() => seat.Seat.Find("edit-toleranceChain[1].toleranceMm[1]") is { IsFocused: true }, "The field has no focus.");
        seat.Settle();
        _ = seat.Seat.See("problem-toleranceChain[1].toleranceMm[1]");
        var wrong = seat.Seat.See("edit-toleranceChain[1].toleranceMm[1]");
        var list = wrong.FindAncestorOfType<ScrollViewer>()!;
        Assert.InRange(wrong.TranslatePoint(new(0, wrong.Bounds.Height), list)!.Value.Y, 0, list.Bounds.Height);
        pictures.Take("system-wrong", isPictured: false);
        pictures.MustBeClean();
    });

    private static string[] Lines(byte[] program) =>
        System.Text.Encoding.Latin1.GetString(program).TrimEnd('\n').Split('\n').Select(l => l.TrimEnd('\r')).ToArray();

    private static Task At(Action<SetupSeat> test, string user = DemoCell.Setter) => SetupSeat.AtAsync(ScreenKeys.System, test, user);
}
