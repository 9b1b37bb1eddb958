using Avalonia.Controls;
using Avalonia.Input;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Who tries the station finds the samples' files where files are chosen,
/// and cannot take one for another without being told.</summary>
public sealed class SamplesTests
{
    [Theory]
    [InlineData(false, "Samples")]
    [InlineData(true, "範例")]
    public Task The_sample_is_set_up_with_the_file_that_is_put_forward(bool isChinese, string name) => At(seat =>
    {
        if (isChinese)
        {
            seat.Seat.Tap("language");
        }

        Begin(seat);
        seat.Seat.Tap("nav-system").Tap("points-read").See("entry-drawing.csv");
        Assert.Equal((name, seat.Seat.Cell.SamplesFolder), (seat.Shell.Choosing!.Places[0].Name, seat.Shell.Choosing.Folder));
        Assert.Equal(["drawing.csv", "part.csv"], seat.Shell.Choosing.Rows.Select(r => r.Name));
        Assert.Equal(Path.Combine(seat.Seat.Cell.SamplesFolder, "drawing.csv"), ((TextBox)seat.Seat.See("chooser-path")).Text);
        seat.Seat.Tap("chooser-confirm").WaitFor(() => seat.Draft.Points.All(p => p.X.Length > 0), "The drawing is not read.");
        Assert.Equal(16, seat.Draft.Points.Count());
        Assert.Empty(seat.Draft.OtherPoints);

        // What was chosen from last is where the next one is chosen, and the file that is meant there is another one.
        seat.Seat.Tap("side-blocks").Tap("program-import").See("entry-counterpart.nc");
        Assert.Equal(Path.Combine(seat.Seat.Cell.SamplesFolder, "counterpart.nc"), ((TextBox)seat.Seat.See("chooser-path")).Text);
        seat.Seat.Tap("chooser-confirm").WaitFor(() => seat.Draft.Program is not null, "The program is not imported.");
    });

    [Fact]
    public Task Whoever_chose_elsewhere_begins_there_and_finds_the_samples_one_tap_away() => At(seat =>
    {
        var folder = Path.GetDirectoryName(seat.JobFile)!;
        seat.Seat.Tap("nav-system").Tap("points-read").Type("chooser-path", Path.Combine(folder, "theoretical.csv")).Tap("chooser-confirm");
        seat.Seat.WaitFor(() => seat.Shell.Choosing is null, "Nothing is chosen.");
        seat.Settle().Seat.Tap("points-read").See("entry-theoretical.csv");
        Assert.Equal(folder, ((TextBox)seat.Seat.See("chooser-path")).Text);
        seat.Seat.Tap("place-0").See("entry-drawing.csv");
        seat.Seat.User.Press(Key.Escape);
    });

    [Fact]
    public Task What_is_written_does_not_go_to_the_samples() => At(seat =>
    {
        _ = seat.Shell.ChooseAsync(new(FileChoiceKind.Folder, "History.Folder", []));
        seat.Seat.WaitFor(() => seat.Shell.Choosing!.Folder.Length > 0, "No folder is shown.");
        Assert.Equal(Path.GetDirectoryName(seat.Seat.Station.Settings.File), seat.Shell.Choosing!.Folder);
        seat.Seat.User.Press(Key.Escape);
    });

    [Fact]
    public Task A_file_that_is_no_drawing_of_these_features_is_told() => At(seat =>
    {
        // A measurement has the labels of the drawing: nothing but its name tells.
        seat.Seat.Tap("nav-system").Tap("points-read").Tap("entry-part.csv").Tap("chooser-confirm");
        seat.Seat.WaitFor(() => seat.Seat.Find("setup-notice") is not null, "Nothing is said.");
        Assert.StartsWith(
            "The job uses the name part.csv for its measurement. If it is one, undo and read the drawing. The table has 17 points.",
            seat.TextOf("setup-notice"),
            StringComparison.Ordinal);
        seat.Seat.Tap("setup-undo");

        // The job's own points have one that nobody measures.
        Begin(seat);
        seat.Seat.Tap("nav-system")
            .Tap("points-read")
            .Type("chooser-path", Path.Combine(Path.GetDirectoryName(seat.JobFile)!, "theoretical.csv"))
            .Tap("chooser-confirm");
        seat.Seat.WaitFor(() => seat.Seat.Find("setup-message") is not null, "Nothing is said.");
        Assert.StartsWith("Nothing imported: 17 rows for 16 points", seat.TextOf("setup-message"), StringComparison.Ordinal);
    });

    [Fact]
    public Task A_dry_run_with_the_drawing_is_told_and_one_with_a_measurement_is_not() => At(seat =>
    {
        seat.Seat.Tap("nav-system");
        seat.Settle().Seat.Tap("dry-run-file").See("entry-part.csv");
        Assert.Equal(Path.Combine(seat.Seat.Cell.SamplesFolder, "part.csv"), ((TextBox)seat.Seat.See("chooser-path")).Text);
        seat.Seat.Tap("chooser-confirm").WaitFor(() => seat.System.Detail is not null, "Nothing is shown.");
        Assert.Null(seat.Seat.Find("dry-run-doubt"));

        // Without the apex the drawing has all that is measured: it would be taken for a perfect part.
        seat.Seat.Tap("dry-run-back")
            .Tap("dry-run-file")
            .Tap("entry-drawing.csv")
            .Tap("chooser-confirm")
            .WaitFor(() => seat.System.Detail is not null, "Nothing is shown.");
        Assert.Equal(
            "Every point of drawing.csv is exactly as designed: this is a drawing, not a measurement. Go back and choose a file from the "
                + "gauge.",
            seat.TextOf("dry-run-doubt"));
    });

    private static void Begin(SetupSeat seat)
    {
        seat.Seat.Tap("nav-points");
        seat.Settle().Seat
            .Tap("setup-anew")
            .Tap("add-line")
            .Tap("add-triangle")
            .Tap("add-curve")
            .Type("edit-features[2].points", "10").User
            .Press(Key.Enter);
        seat.Settle();
    }

    private static Task At(Action<SetupSeat> test) => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter);
            test(new(seat));
        },
        hasSamples: true);
}
