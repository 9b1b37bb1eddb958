using Avalonia;
using Avalonia.Controls;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Where things stand on the set-up screens, and that they stay there.</summary>
public sealed class SetupLayoutTests
{
    private const double Slack = 2;

    [Fact]
    public Task A_check_box_stands_beside_its_words_at_the_height_of_the_field_beside_it() => SetupSeat.AtAsync(Screens.System, seat =>
    {
        seat.Shell.Editing.Change("", d => d with { Alignment = d.Alignment with { Kind = "best-fit" } });
        seat.Settle().Seat.Tap("side-machine");
        var check = seat.Seat.See("edit-alignment.lockX");
        var (words, box) = (check.GetVisualDescendants().OfType<TextBlock>().Single(), check.GetVisualDescendants().OfType<Border>().First(b => b.Name == "NormalRectangle"));
        Assert.Equal(MiddleOf(words), MiddleOf(box), Slack);
        Assert.Equal(MiddleOf(seat.Seat.See("edit-alignment.kind")), MiddleOf(box), Slack);

        double MiddleOf(Visual visual) => visual.TranslatePoint(new(0, visual.Bounds.Height / 2), seat.Seat.Window)!.Value.Y;
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task Buttons_of_the_bar_stay_where_they_are_whatever_is_to_be_corrected(bool isChinese) => SetupSeat.AtAsync(Screens.Points, seat =>
    {
        if (isChinese)
        {
            seat.Seat.Tap("language");
        }

        var before = Places();
        seat.Seat.Tap("setup-anew");
        seat.Settle();
        seat.Seat.WaitFor(() => seat.Setup.HasProblems && Places().SequenceEqual(before), $"They stand at {string.Join(", ", Places())} and stood at {string.Join(", ", before)}.");
        seat.Seat.Tap("add-line").Tap("add-triangle").Tap("add-curve");
        seat.Settle();
        seat.Seat.WaitFor(() => seat.Shell.Editing.Problems.Count > 9 && Places().SequenceEqual(before), "They stand elsewhere with two digits.");

        double[] Places() => [.. new[] { "setup-undo", "setup-redo", "setup-anew", "setup-discard", "setup-problems", "setup-save" }.Select(id => Math.Round(seat.Seat.See(id).TranslatePoint(default, seat.Seat.Window)!.Value.X))];
    });
}
