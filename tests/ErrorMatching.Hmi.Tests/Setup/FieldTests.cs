using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.Input;
using Avalonia.VisualTree;

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
    public Task What_is_wrong_is_made_where_something_is_and_goes_with_it() => SetupSeat.AtAsync("points", seat =>
    {
        var notes = seat.Seat.Window.GetVisualDescendants().OfType<FieldNote>().ToArray();
        Assert.NotEmpty(notes);
        Assert.All(notes, n => Assert.Null(n.Child));

        seat.Seat.Type("edit-name", " ");
        seat.Settle();
        Assert.NotNull(seat.Seat.TextOf("problem-name"));
        Assert.Single(notes, n => n.Child is not null);

        seat.Seat.Type("edit-name", "Named");
        seat.Settle();
        Assert.Null(seat.Seat.Find("problem-name"));
    });
}
