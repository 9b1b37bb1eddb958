using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Where things stand on the set-up screens, and that they stay there.</summary>
public sealed class SetupLayoutTests
{
    private const double Slack = 2;

    [Fact]
    public Task A_check_box_stands_beside_its_words_at_the_height_of_the_field_beside_it() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        seat.Shell.Editing.Change("", d => d.With("$.alignment.kind", "best-fit"));
        seat.Settle().Seat.Tap("side-machine");
        var check = seat.Seat.See("edit-alignment.lockX");
        var (words, box) = (
            check.GetVisualDescendants().OfType<TextBlock>().Single(),
            check.GetVisualDescendants().OfType<Border>().First(b => b.Name == "NormalRectangle"));
        Assert.Equal(MiddleOf(words), MiddleOf(box), Slack);
        Assert.Equal(MiddleOf(seat.Seat.See("edit-alignment.kind")), MiddleOf(box), Slack);

        double MiddleOf(Visual visual) => visual.TranslatePoint(new(0, visual.Bounds.Height / 2), seat.Seat.Window)!.Value.Y;
    });

    [Fact]
    public Task Coordinates_stand_with_their_decimal_signs_under_each_other_and_are_not_changed_by_it() =>
        SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        string[] typed = ["-31.950", "76", "5.1234", "-0.5"];
        seat.Shell.Editing.Change(
            "",
            d => d.WithFeature(
                0,
                f => f with
                {
                    Flanks = [
                        [
                            new("1", typed[0], "1"), new("2", "1", "1"), new("3", typed[1], "1"), new("4", "1", "1"),
                            new("5", typed[2], "1"), new("6", "1", "1"), new("7", typed[3], "1")]]
                }));
        seat.Settle();
        var signs = typed.Select((text, i) =>
        {
            var box = (TextBox)seat.Seat.See($"edit-features[0].points[{2 * i}]/x");
            Assert.Equal(text, box.Text);
            var presenter = box.GetVisualDescendants().OfType<TextPresenter>().Single();
            var sign = text.IndexOf('.', StringComparison.Ordinal) is >= 0 and var at ? at : text.Length;
            return presenter.TranslatePoint(presenter.TextLayout.HitTestTextPosition(sign).TopLeft, seat.Seat.Window)!.Value.X;
        }).ToArray();
        Assert.All(signs, x => Assert.Equal(signs[0], x, 1.0));
        Assert.Equal(typed[1], seat.Draft.Features[0].Flanks[0][2].X);
    });

    [Fact]
    public Task Most_points_of_the_sample_are_seen_at_once() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        // While the cell runs: that it does not takes a line above.
        seat.Seat.RunCell();
        seat.Settle();
        var seen = seat.System.Coordinates.Select(c => seat.Seat.Find(c.X.AutomationId)).Count(
            f => f is not null && Layout.Seen(f, seat.Seat.Window).Height > f.Bounds.Height - 1);
        Assert.InRange(seen, 10, seat.System.Coordinates.Count);
    });

    [Fact]
    public Task Lines_of_a_program_are_whole_targets_for_whoever_takes_the_largest() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        const double Target = 15 / 25.4 * 96;
        seat.Seat.Tap("side-blocks").WaitFor(() => seat.System.Picture is not null, "The program is not opened.");
        var text = (ProgramText)seat.Seat.See("program-text");
        Assert.True(text.RowHeight < Target);
        seat.Shell.Preferences.TouchSize = TouchSize.Largest;
        seat.Settle();
        Assert.InRange(text.RowHeight, Target, 1.1 * Target);
        Assert.Empty(Layout.Problems(seat.Seat.Window));
    });

    [Fact]
    public Task Points_with_three_coordinates_have_the_whole_width() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        seat.Shell.Editing.Change("", d => d.WithFeature(0, f => f with { Plane = "ZX" }));
        seat.Settle().Seat.See("edit-features[0].points[1]/z");
        Assert.Equal(seat.System.Coordinates, seat.System.Pairs.Select(p => p.First));
        Assert.True(seat.Seat.See("edit-features[0].points[1]/x").Bounds.Width > 200);
        Assert.Empty(Layout.Problems(seat.Seat.Window));
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task What_is_said_of_the_last_step_moves_nothing_below_it(bool isChinese) => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        if (isChinese)
        {
            seat.Seat.Tap("language");
        }

        var before = Top();
        seat.Shell.Editing.Change("", d => d.With("$.workOrder", "WO-7"));
        seat.Settle().Seat.See("setup-state");
        Assert.Equal(before, Top());
        seat.System.Paste(Table(seat));
        seat.Settle().Seat.See("setup-notice");
        Assert.Equal(isChinese ? "表中有 16 點。" : "The table has 16 points.", seat.TextOf("setup-notice"));
        Assert.Null(seat.Seat.Find("setup-message"));
        Assert.Null(seat.Seat.Find("setup-state"));
        Assert.Equal(before, Top());

        // Two lines, as where points are said that no feature has.
        seat.System.Paste(Table(seat) + "\n90\t1\t1\n91\t1\t1");
        seat.Seat.WaitFor(() => ((TextBlock)seat.Seat.See("setup-notice")).TextLayout.TextLines.Count == 2, "It is not said in two lines.");
        Assert.Equal(before, Top());
        seat.System.Paste("nothing");
        seat.Settle().Seat.See("setup-message");
        Assert.Equal(before, Top());

        double Top() => Math.Round(seat.Seat.See("side-coordinates").TranslatePoint(default, seat.Seat.Window)!.Value.Y);

        static string Table(SetupSeat seat) =>
            string.Join('\n', seat.Draft.Features.SelectMany(f => f.Points).Select(p => $"{p.Label}\t{p.X}1\t{p.Y}"));
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task Buttons_of_the_bar_stay_where_they_are_whatever_is_to_be_corrected(bool isChinese) =>
        SetupSeat.AtAsync(ScreenKeys.Points, seat =>
    {
        if (isChinese)
        {
            seat.Seat.Tap("language");
        }

        var before = Places();
        seat.Seat.Tap("setup-anew");
        seat.Settle();
        seat.Seat.WaitFor(
            () => seat.Setup.HasProblems && Places().SequenceEqual(before),
            $"They stand at {string.Join(", ", Places())} and stood at {string.Join(", ", before)}.");
        seat.Seat.Tap("add-line").Tap("add-triangle").Tap("add-curve");
        seat.Settle();
        seat.Seat.WaitFor(
            () => seat.Shell.Editing.Problems.Count > 9 && Places().SequenceEqual(before), "They stand elsewhere with two digits.");
        seat.Seat.Type("edit-name", "Piece");
        seat.Settle();
        seat.Seat.WaitFor(
            () => seat.Setup.StepText.Contains("30", StringComparison.Ordinal) && Places().SequenceEqual(before),
            "They stand elsewhere when the next step is counted.");

        double[] Places() => [
            .. new[]
            {
                "setup-undo",
                "setup-redo",
                "setup-anew",
                "setup-discard",
                "setup-problems",
                "setup-save"
            }.Select(id => Math.Round(seat.Seat.See(id).TranslatePoint(default, seat.Seat.Window)!.Value.X))];
    });
}
