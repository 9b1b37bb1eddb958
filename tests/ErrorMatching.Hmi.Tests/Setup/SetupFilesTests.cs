using Avalonia;
using Avalonia.Controls;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Files that are read on the system set-up: coordinates, programs, and a measurement to try the draft with.</summary>
public sealed class SetupFilesTests
{
    private static readonly string Part = Repository.PathTo("samples", "complex-mating", "part.csv");

    [Fact]
    public Task Coordinates_are_read_from_a_file_and_a_broken_line_is_named() => At((seat, folder) =>
    {
        var before = seat.Draft;
        var (good, broken) = (Path.Combine(folder, "drawing.csv"), Path.Combine(folder, "broken.csv"));
        File.WriteAllText(good, "\uFEFFpoint,x,y\r\n1,-31.951,76\r\n2,-32.3,58\r\n");
        File.WriteAllText(broken, "point,x,y\n1,-40,76\n2,-32.3O,58\n");
        Choose(seat, "points-read", broken);
        Assert.Equal("Nothing imported: the coordinates in line 3 cannot be read: 2,-32.3O,58", seat.TextOf("setup-message"));
        Assert.True(seat.Draft.IsSame(before));
        seat.Seat.Tap("language");
        Choose(seat, "points-read", broken);
        Assert.Equal("未讀入任何座標：第 3 行的座標無法讀取：2,-32.3O,58", seat.TextOf("setup-message"));
        seat.Seat.Tap("language");
        Choose(seat, "points-read", good);
        Assert.Null(seat.Seat.Find("setup-message"));
        Assert.Equal(("-31.951", "76", "-32.3", "58"), (At(0).X, At(0).Y, At(1).X, At(1).Y));
        Assert.Equal("-32.3", ((TextBox)seat.Seat.See("edit-features[0].points[1]/x")).Text);
        seat.Seat.Tap("setup-undo");
        Assert.True(seat.Draft.IsSame(before));
        seat.Seat.Tap("setup-redo");
        Assert.Equal("-32.3", At(1).X);
        seat.Seat.User.Press(Avalonia.Input.Key.Z, Avalonia.Input.RawInputModifiers.Control);
        Assert.True(seat.Draft.IsSame(before));

        // A file without any, one that is none, and none at all.
        File.WriteAllText(good, "nothing here\n");
        Choose(seat, "points-read", good);
        Assert.Equal(Texts.Current["System.NoCoordinates"], seat.TextOf("setup-message"));
        seat.Seat.Tap("points-read").Tap("chooser-leave");
        Assert.True(seat.Draft.IsSame(before));

        PointDraft At(int point) => seat.Draft.Features[0].Flanks[0][point];
    });

    [Fact]
    public Task A_dry_run_with_a_file_is_what_the_console_says_of_it_and_a_broken_one_is_named() => At((seat, folder) =>
    {
        var entries = seat.Seat.Station.Store.AuditHead().Seq;
        Choose(seat, "dry-run-file", Part);
        seat.Seat.WaitFor(() => seat.System.Detail is not null, "Nothing is shown.");
        Assert.Equal("part.csv", seat.TextOf("detail-title"));
        var console = MatingRun.Run(
            new(seat.JobFile), new() { Part = new("part.csv", File.ReadAllBytes(Part)) }, TestContext.Current.CancellationToken).Result!;
        Assert.Equal(
            StoredReport.Read(console.ReportJson()).Match!.KeyPoints.Select(p => p.Correction),
            seat.System.Detail!.Stored.Report!.KeyPoints.Select(p => p.Correction));
        seat.Seat.Tap("tab-decisions");
        Assert.Contains("Proved", seat.TextOf("detail-proof"), StringComparison.Ordinal);

        // By how much it moves at most, and where, is its own; it has no course, and its program can be looked at.
        var move = Cell.LargestMove.Of(console);
        Assert.InRange(move.Mm, console.Report.KeyPoints.Max(p => p.Correction.Length), double.MaxValue);
        Assert.Equal(Texts.Current.With("Head.LargestAt", Shown.Mm(move.Mm), StoredMove.PlaceOf(move.At)), seat.TextOf("detail-largest"));
        Assert.Null(seat.Seat.Find("tab-course"));
        seat.Seat.Tap("tab-program").See("program");
        Assert.Equal(
            System.Text.Encoding.Latin1.GetString(console.Program.Span).Split('\n').Select(l => l.TrimEnd('\r')).Where(l => l.Length > 0),
            seat.System.Detail.Lines!.Select(l => l.Modified).Where(l => l.Length > 0));

        // Escape leads back to the form, which is as it was.
        seat.Seat.User.Press(Avalonia.Input.Key.Escape);
        seat.Seat.See("side-coordinates");
        var broken = Path.Combine(folder, "part.csv");
        var lines = File.ReadAllLines(Part);
        lines[4] += ",what?";
        File.WriteAllLines(broken, lines);
        Choose(seat, "dry-run-file", broken);
        Assert.Null(seat.System.Detail);
        Assert.Contains("part.csv", seat.TextOf("setup-message"), StringComparison.Ordinal);
        Assert.Contains("line 5", seat.TextOf("setup-message"), StringComparison.Ordinal);
        Assert.Equal(entries, seat.Seat.Station.Store.AuditHead().Seq);
        Assert.Empty(seat.Seat.Station.Store.Search(new()));
    });

    [Fact]
    public Task Nothing_works_as_long_as_a_file_is_chosen() => At((seat, _) =>
    {
        var before = Place();
        seat.Seat.Tap("dry-run-file").See("chooser-path");
        Assert.Null(seat.Seat.Find("working"));

        // A button that was pressed comes back to its size in its own time.
        seat.Seat.WaitFor(() => Place() == before, "The button is somewhere else.");
        seat.Seat.Tap("chooser-leave");
        seat.Seat.WaitFor(() => !seat.System.DryRunFile.IsRunning, "It goes on without a file.");
        Assert.Null(seat.System.Detail);

        // Once one is chosen, something goes on until it is tried.
        var working = new List<bool>();
        seat.System.DryRunFile.PropertyChanged += (_, e) => working.AddRange(
            e.PropertyName == nameof(LongCommand.IsWorking) ? [seat.System.DryRunFile.IsWorking] : []);
        Choose(seat, "dry-run-file", Part);
        seat.Seat.WaitFor(() => seat.System.Detail is not null, "Nothing is shown.");
        Assert.Equal([true, false, true, false], working);

        Point Place() => seat.Seat.See("dry-run-file").TranslatePoint(default, seat.Seat.Window)!.Value;
    });

    [Fact]
    public Task A_dry_run_that_is_cancelled_shows_nothing() => At((seat, _) =>
    {
        seat.Seat.Cell.Run();
        seat.Seat.Cell.Deliver(1, 0);
        seat.Seat.WaitFor(1, Cell.CorrectionState.Proposed);
        seat.System.DryRun.Execute(null);
        Assert.True(seat.System.DryRun.IsRunning);
        seat.System.DryRun.Cancel.Execute(null);
        seat.Seat.WaitFor(() => !seat.System.DryRun.IsRunning, "It is not cancelled.");
        Assert.Null(seat.System.Detail);
        Assert.Null(seat.Seat.Find("setup-message"));
        seat.Seat.Tap("dry-run").WaitFor(() => seat.System.Detail is not null, "It cannot be done again.");
    });

    private static void Choose(SetupSeat seat, string button, string file)
    {
        seat.Seat.Tap(button).Type("chooser-path", file).Tap("chooser-confirm");
        seat.Seat.WaitFor(
            () => seat.Shell.Choosing is null && !seat.System.ReadPoints.IsRunning && !seat.System.DryRunFile.IsRunning,
            "The file is not read.");
        seat.Settle();
    }

    private static Task At(Action<SetupSeat, string> test) => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        using var made = new TemporaryFolder();
        test(seat, made.Path);
    });
}
