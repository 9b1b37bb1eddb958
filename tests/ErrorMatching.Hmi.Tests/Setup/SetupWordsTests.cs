using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Shapes;
using Avalonia.Media;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using Path = System.IO.Path;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What the set-up says of fields, of saving and of what cannot be done now.</summary>
public sealed class SetupWordsTests
{
    [Fact]
    public Task What_was_saved_is_said_in_the_language_of_the_screen_until_something_else_is_done() => SetupSeat.AtAsync("system", seat =>
    {
        seat.Seat.Tap("side-machine").Type("edit-compensation.gain", "0.5");

        // The same program again, byte for byte: it is no other one.
        var program = Path.Combine(Path.GetDirectoryName(seat.JobFile)!, seat.Draft["$.counterpart.program"]);
        Import(seat, program);
        Save(seat);
        Assert.Equal("Saved: the next part uses it.", seat.TextOf("setup-notice"));
        Texts.Current.Language = Language.TraditionalChinese;
        seat.Settle();
        Assert.Equal(Texts.Current["Setup.Saved"], seat.TextOf("setup-notice"));
        Texts.Current.Language = Language.English;
        seat.Settle().Seat.Tap("nav-points").Tap("nav-system");
        Assert.Null(seat.Settle().Seat.Find("setup-notice"));

        // Another one, though under the same name.
        var other = Path.Combine(Path.GetDirectoryName(seat.JobFile)!, "..", Path.GetFileName(program));
        File.WriteAllText(other, File.ReadAllText(program).Replace("%", "%\n(ANOTHER)", StringComparison.Ordinal));
        Import(seat, other);
        Save(seat);
        Assert.Contains("The base program has changed.", seat.TextOf("setup-notice"), StringComparison.Ordinal);
    });

    [Fact]
    public Task A_block_that_is_not_there_is_said_once_in_either_language() => SetupSeat.AtAsync("system", seat =>
    {
        seat.Seat.Tap("side-blocks").Type("edit-features[0].blocks", "N4711");
        seat.Settle();
        Assert.Equal("The program has no such block: N4711", seat.TextOf("problem-features[0].blocks"));
        Texts.Current.Language = Language.TraditionalChinese;
        Assert.Equal("程式中沒有此單節：N4711", seat.Settle().TextOf("problem-features[0].blocks"));
    });

    [Fact]
    public Task Fields_that_may_stay_empty_say_so() => SetupSeat.AtAsync("system", seat =>
    {
        // Verifications compare with it, whatever the compensation follows.
        Assert.Equal("counterpart.csv", ((TextField)seat.System.FieldOf("edit-counterpart.measured")).Text);
        seat.Shell.Editing.BeginAnew.Execute(null);
        seat.Settle();
        Assert.Equal(
            ("", "optional"),
            (
                ((TextField)seat.System.FieldOf("edit-counterpart.measured")).Text,
                ((TextField)seat.System.FieldOf("edit-counterpart.measured")).Placeholder));
        Assert.Equal(
            ["empty: 0.5", "empty: 0", "optional", "empty: 1", "empty: 10"],
            new[]
            {
                "edit-counterpart.mapMm",
                "edit-counterpart.frame.translateMm[1]",
                "edit-originCheck.point",
                "edit-compensation.limitMm",
                "edit-gauge.measuring.probingSpeedMmPerS"
            }.Select(f => ((TextField)seat.System.FieldOf(f)).Placeholder));
        Assert.Equal("", ((TextField)seat.System.FieldOf("edit-counterpart.toolDiameterMm")).Placeholder);

        // It stands in the field on the screen as well, as long as the field is empty.
        seat.Seat.Tap("side-machine");
        Assert.Equal("empty: 1", InField("edit-compensation.limitMm"));
        Assert.Null(InField("edit-counterpart.toolDiameterMm"));
        seat.Seat.Type("edit-compensation.limitMm", "2");
        Assert.Null(InField("edit-compensation.limitMm"));
        seat.Seat.Type("edit-compensation.limitMm", "");
        Assert.Equal("empty: 1", InField("edit-compensation.limitMm"));
        seat.Settle();

        // What says that it may stay empty is never told as missing.
        var optional = new[]
        {
            seat.System.Frame,
            seat.System.Alignment,
            seat.System.Compensation,
            seat.System.Gauge
        }.SelectMany(f => f).OfType<TextField>().Where(f => f.Placeholder.Length > 0).ToArray();
        Assert.True(optional.Length > 10);
        seat.Seat.WaitFor(() => seat.Shell.Editing.IsChecked, "It is not looked through.");
        Assert.All(optional, f => Assert.DoesNotContain(seat.Shell.Editing.Problems, p => p.Field == f.Path));

        string? InField(string id) =>
            seat.Seat.See(id)
                .GetVisualDescendants()
                .OfType<TextBlock>()
                .SingleOrDefault(t => t.IsEffectivelyVisible && t.Bounds.Width > 0 && !string.IsNullOrEmpty(t.Text))?.Text;
    });

    [Fact]
    public Task Columns_of_tolerances_stand_under_each_other() => SetupSeat.AtAsync("system", seat =>
    {
        seat.Shell.Editing.Change("", d => d.WithFeature(0, f => f with { Tolerance = "chain:rss" }));
        seat.Settle().Seat.Tap("side-tolerances");
        Assert.Single(
            Enumerable.Range(0, seat.Draft.Features.Count)
                .Select(f => Math.Round(seat.Seat.See($"edit-features[{f}].plane").TranslatePoint(default, seat.Seat.Window)!.Value.X))
                .Distinct());
    });

    [Fact]
    public Task What_cannot_be_undone_looks_so() => SetupSeat.AtAsync("points", seat =>
    {
        var (undo, anew) = ((Button)seat.Seat.See("setup-undo"), seat.Seat.See("setup-anew"));
        Assert.False(undo.IsEffectivelyEnabled);
        var off = Stroke(undo);
        seat.Seat.User.Click(anew);
        Assert.True(undo.IsEffectivelyEnabled);
        Assert.NotEqual(off, Stroke(undo));

        static Color Stroke(Button button) =>
            ((ISolidColorBrush)button.GetVisualDescendants().OfType<Shape>().First(s => s.Classes.Contains("icon")).Stroke!).Color;
    });

    [Fact]
    public Task Dialogs_of_every_act_have_room_for_their_words_in_both_languages() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter);
        var pictures = new Pictures(seat);
        foreach (var act in new[] { Act.Approve, Act.Reject, Act.Release, Act.Revert })
        {
            seat.Shell.Sign(new(
                seat.Station,
                seat.Station.Session.Who!,
                act,
                "#3 · 0002",
                act is Act.Reject or Act.Revert,
                (_, _, _) => Task.CompletedTask));
            pictures.Take("signing-" + act.ToString().ToLowerInvariant(), isPictured: false);
            seat.Tap("signing-leave");
        }

        pictures.MustBeClean();
    });

    private static void Import(SetupSeat seat, string program)
    {
        var importing = seat.System.ImportProgramAsync(program);
        seat.Seat.WaitFor(() => importing.IsCompleted && seat.Draft.Program is not null, "It is not imported.");
    }

    private static void Save(SetupSeat seat)
    {
        seat.Settle().Seat.Save();
        seat.Seat.WaitFor(() => seat.Seat.Find("setup-notice") is not null, "It is not saved.");
    }
}
