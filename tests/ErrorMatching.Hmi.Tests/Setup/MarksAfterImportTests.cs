using Avalonia;
using Avalonia.Media;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The marks of features in the program, when another picture of it takes the place of the one that was there.</summary>
public sealed class MarksAfterImportTests
{
    private const int Reach = 6;

    [Fact]
    public Task Features_stay_marked_after_two_imports_and_after_discarding_them() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var program = Path.Combine(Path.GetDirectoryName(seat.JobFile)!, seat.Draft["$.counterpart.program"]);
        using var made = new TemporaryFolder();
        var other = Path.Combine(made.Path, Path.GetFileName(program));
        File.WriteAllText(other, File.ReadAllText(program).Replace("%", "%\n(ANOTHER)", StringComparison.Ordinal));
        seat.Seat.Tap("side-blocks");
        var drawn = Marked(seat, "when it is opened");
        Import(seat, other);
        Assert.Equal(drawn, Marked(seat, "after an import"));
        Import(seat, program);
        Assert.Equal(drawn, Marked(seat, "after a second import"));
        Import(seat, other);
        seat.Seat.Tap("setup-discard");
        seat.Settle();
        Assert.Equal(drawn, Marked(seat, "after discarding"));

        // From another side: the program is another one while nobody sees it.
        Import(seat, other);
        seat.Seat.Tap("side-coordinates").Tap("setup-discard");
        seat.Settle();
        seat.Seat.WaitFor(() => seat.System.Opening.IsCompleted, "The program is not opened.");
        seat.Seat.Tap("side-blocks");
        Assert.Equal(drawn, Marked(seat, "after discarding on another side"));
    });

    private static void Import(SetupSeat seat, string file)
    {
        seat.Seat.Tap("program-import").Type("chooser-path", file).Tap("chooser-confirm");
        seat.Seat.WaitFor(() => seat.Shell.Choosing is null && !seat.System.ReadProgram.IsRunning, "The program is not read.");
        seat.Settle();
    }

    // Beside the text stands the name of each feature; what is drawn around the middle of its first move is returned.
    private static Color[] Marked(SetupSeat seat, string when)
    {
        seat.Seat.WaitFor(
            () => seat.System.Opening.IsCompleted && seat.System.Picture is { Marks.Count: > 0 }, $"Nothing is marked {when}.");
        seat.Seat.User.Settle();
        var picture = seat.System.Picture!;
        var (text, path) = ((ProgramText)seat.Seat.See("program-text"), (PathPlot)seat.Seat.See("program-path"));
        Assert.Same(picture, path.Picture);
        var names = ((IDrawnWords)text).DrawnWords.Select(w => w.Words).ToHashSet();
        Assert.All(picture.Marks, m => Assert.True(names.Contains(m.Name), $"{m.Name} is not beside the text {when}."));
        return [.. picture.Marks.SelectMany(m => Around(m.Ranges[0].First))];

        IEnumerable<Color> Around(int block)
        {
            var (program, motion) = (picture.Program, picture.Program.Path.MotionOf(block));
            var (from, to) = program.Moves.EndsOf(motion)!.Value;
            var place = path.TranslatePoint(path.View.At(program.Moves.NearestOn(motion, from.Lerp(to, 0.5))), seat.Seat.Window)!.Value;
            var offsets = Enumerable.Range(-Reach, (2 * Reach) + 1);
            return offsets.SelectMany(x => offsets.Select(y => new PixelPoint(
                (int)place.X + x, (int)place.Y + y))).Select(seat.Seat.User.PixelAt);
        }
    }
}
