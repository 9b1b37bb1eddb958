using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi.Tests;

public sealed class FieldTests
{
    private const string Long = "A piece with a name that is longer than the field that it is typed into";

    [Fact]
    public Task A_long_text_is_moved_so_that_the_caret_is_seen() => SetupSeat.AtAsync("points", seat =>
    {
        var box = (TextBox)seat.Seat.See("edit-name");
        seat.Seat.Type("edit-name", Long);
        var scroller = box.FindDescendantOfType<LineScroller>()!;
        var line = box.FindDescendantOfType<TextPresenter>()!;
        Assert.True(line.Bounds.Width > 2 * scroller.Bounds.Width, "The text is not longer than the field.");
        Assert.Equal(scroller.Bounds.Width, line.Bounds.Right, 1.0);

        // What is tapped is what is seen there: not where it was tapped to begin, which would be a double tap.
        seat.Seat.User.Click(box, new(0.4 * box.Bounds.Width, box.Bounds.Height / 2));
        Assert.InRange(box.CaretIndex, Long.Length / 2, Long.Length - 2);

        seat.Seat.User.Press(Key.Home);
        Assert.Equal(0, line.Bounds.Left, 1.0);
        seat.Seat.User.Press(Key.End, RawInputModifiers.Shift);
        Assert.Equal(Long, box.SelectedText);
        Assert.Equal(scroller.Bounds.Width, line.Bounds.Right, 1.0);

        // A short text begins where a field begins, and a count stands in its middle.
        seat.Seat.Type("edit-name", "A");
        Assert.Equal(0, line.Bounds.Left, 1.0);
        var count = seat.Seat.See("edit-features[0].points").FindDescendantOfType<LineScroller>()!;
        Assert.Equal(count.Bounds.Width / 2, count.Child!.Bounds.Center.X, 1.0);
    });

    [Fact]
    public Task What_is_wrong_is_said_in_the_strip_for_the_field_with_the_focus_else_for_the_first() => SetupSeat.AtAsync("points", seat =>
    {
        Assert.Null(seat.Seat.Find("setup-told"));
        seat.Seat.Type("edit-name", " ");
        seat.Settle();
        Assert.Equal(("Workpiece", "Fill this in."), (seat.TextOf("setup-told"), seat.TextOf("problem-name")));
        Assert.DoesNotContain("wrong", seat.Seat.See("edit-name").Classes);

        // Of another field with its row, as several have that name; where the focus is gone to one that is well, of the first again.
        seat.Seat.Tap("edit-features[2].name").Type("edit-features[2].name", "L/1");
        seat.Settle();
        Assert.Equal(
            ("L/1 · Name", seat.Setup.Features[2].Name.Problem), (seat.TextOf("setup-told"), seat.TextOf("problem-features[2].name")));
        Assert.Contains("wrong", seat.Seat.See("edit-features[2].name").Classes);
        Assert.Null(seat.Seat.Find("problem-name"));
        _ = seat.Seat.See("edit-workOrder").Focus();
        seat.Settle();
        Assert.Equal("Workpiece", seat.TextOf("setup-told"));
        Assert.Equal("Fill this in.", AutomationProperties.GetHelpText(seat.Seat.See("edit-name")));

        seat.Seat.Tap("edit-name").Type("edit-name", "Named").Tap("edit-features[2].name").Type("edit-features[2].name", "C1");
        seat.Settle();
        Assert.Null(seat.Seat.Find("setup-told"));
        Assert.Null(seat.Seat.Find("problem-name"));
    });

    [Fact]
    public Task What_is_still_to_be_filled_in_says_so_in_the_empty_field_once_it_is_told() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var boxes = new[] { "edit-features[0].points[1]", "edit-features[0].points[0]/x", "edit-features[0].points[1]/y" };
        seat.Seat.Tap("setup-anew");
        seat.Shell.Editing.Change(
            "", d => d with { Name = "Piece", Features = [FeatureDraft.New(ErrorMatching.Mating.FeatureKinds.Of("line"), "L1", d)] });
        seat.Shell.Editing.Change(
            "",
            d => d.WithFeature(0, f => f with { Flanks = [[f.Flanks[0][0], f.Flanks[0][1] with { Label = "" }, .. f.Flanks[0].Skip(2)]] }));
        seat.Settle();
        Assert.All(boxes, b => Assert.Equal("", ((TextBox)seat.Seat.See(b)).PlaceholderText));
        seat.Seat.Tap("setup-problems");
        seat.Settle();
        foreach (var (language, words) in new[] { (Language.TraditionalChinese, "待填"), (Language.English, "to fill in") })
        {
            Texts.Current.Language = language;
            seat.Settle();
            Assert.All(boxes, b => Assert.Equal(words, ((TextBox)seat.Seat.See(b)).PlaceholderText));
            Assert.Empty(Layout.Problems(seat.Seat.Window));
        }
    });
}
