using Avalonia.Input;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Blocks are found by the key points that they lead past, as the sample's job has them;
/// whoever sits there looks at them and may take them back.</summary>
public sealed class FoundBlocksTests
{
    private static readonly string[] Paper = ["N120", "N130..N160", "N170..N1190"];

    [Fact]
    public Task Those_of_all_features_are_found_in_one_tap_and_taken_back_in_another() => At(seat =>
    {
        Assert.False(seat.Seat.See("blocks-find").IsEffectivelyEnabled);
        Empty(seat, 0, 1, 2);
        seat.Seat.Tap("blocks-find");
        Wait(seat);
        Assert.Equal(Paper, seat.Draft.Features.Select(f => f.Blocks));
        Assert.Equal("Found for L1, L2L3, C1. Check them in the drawn path.", seat.TextOf("setup-notice"));
        Assert.Equal(["L1", "L2L3", "C1"], seat.System.Picture!.Marks.Where(m => m.Ranges.Count > 0).Select(m => m.Name));
        Assert.Empty(seat.Shell.Editing.Problems);
        Assert.False(seat.Seat.See("blocks-find").IsEffectivelyEnabled);

        // What would replace blocks says so, and does not ask for it.
        seat.System.Picture.Light(129);
        seat.Seat.User.Settle();
        Assert.Equal("Replace for L1", seat.System.Picture.TakeText);
        Assert.DoesNotContain("accent", seat.Seat.See("program-take").Classes);
        seat.Seat.Tap("setup-undo");
        seat.Settle();
        Assert.All(seat.Draft.Features, f => Assert.Equal("", f.Blocks));
    });

    [Fact]
    public Task What_has_its_blocks_keeps_them_and_what_is_not_found_is_said() => At(seat =>
    {
        seat.Shell.Editing.Change(
            "",
            d => d.WithFeature(1, f => f with { Blocks = "N130..N150" }).WithFeature(
                2, f => f with { Flanks = [[.. f.Flanks[0].Select((p, i) => i == 3 ? p with { Y = "" } : p)]] }));
        Empty(seat, 0, 2);
        seat.Seat.Tap("blocks-find");
        Wait(seat);
        Assert.Equal(["N120", "N130..N150", ""], seat.Draft.Features.Select(f => f.Blocks));
        Assert.StartsWith("Found for L1.", seat.TextOf("setup-notice"), StringComparison.Ordinal);
        Assert.Contains("Not found for C1: a key point has no coordinates", seat.TextOf("setup-notice"), StringComparison.Ordinal);
        Assert.Equal("C1", seat.System.Picture!.Feature);
    });

    [Fact]
    public Task Blocks_that_were_lit_before_others_were_typed_are_not_offered_any_more() => At(seat =>
    {
        Empty(seat, 2);
        var picture = seat.System.Picture!;
        picture.Light(129);
        seat.Seat.User.Settle();
        Assert.True(seat.Seat.See("program-take").IsEffectivelyEnabled);
        seat.Seat.Type("edit-features[2].blocks", "N170..N1190");
        seat.Seat.User.Press(Key.Tab);
        seat.Settle();
        Assert.Equal("N170..N1190", seat.Draft.Features[2].Blocks);
        Assert.Same(picture, seat.System.Picture);
        Assert.Null(picture.Selection);
        Assert.False(seat.Seat.See("program-take").IsEffectivelyEnabled);
    });

    [Fact]
    public Task Who_may_not_edit_finds_none() => SetupSeat.AtAsync(
        ScreenKeys.System,
        seat =>
        {
            seat.Seat.Tap("side-blocks").WaitFor(() => seat.System.Picture is not null, "The program is not opened.");
            seat.Settle();
            Assert.False(seat.Seat.See("blocks-find").IsEffectivelyEnabled);
        },
        DemoCell.Operator);

    private static Task At(Action<SetupSeat> test) => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        seat.Seat.Tap("side-blocks").WaitFor(() => seat.System.Picture is not null, "The program is not opened.");
        seat.Settle();
        test(seat);
    });

    private static void Empty(SetupSeat seat, params int[] features)
    {
        seat.Shell.Editing.Change("", d => features.Aggregate(d, (to, i) => to.WithFeature(i, f => f with { Blocks = "" })));
        seat.Settle();
    }

    private static void Wait(SetupSeat seat)
    {
        seat.Seat.WaitFor(() => !seat.System.FindBlocks.IsRunning, "The search does not end.");
        seat.Settle();
        seat.Seat.WaitFor(() => seat.System.Opening.IsCompleted, "Features are not marked.");
        seat.Seat.User.Settle();
    }
}
