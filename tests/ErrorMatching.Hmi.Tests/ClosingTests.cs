namespace ErrorMatching.Hmi.Tests;

/// <summary>Closing the window while a set-up is not saved.</summary>
public sealed class ClosingTests
{
    [Fact]
    public Task A_user_who_closes_with_unsaved_changes_is_asked_first() => SetupSeat.AtAsync("points", here =>
    {
        var (window, shell) = (here.Seat.Window, here.Shell);
        var closed = 0;
        window.Closed += (_, _) => closed++;
        shell.Editing.Change("", d => d with { Name = "Other" });
        here.Settle();
        Assert.True(shell.Editing.IsChanged);
        Assert.True(here.Seat.User.StaysOpen());
        here.Seat.User.Settle();
        Assert.Equal(0, closed);
        Assert.Contains(shell.Editing.Place!.Name, here.TextOf("leaving-told"), StringComparison.Ordinal);
        Assert.False(shell.IsFree);

        here.Seat.Tap("leaving-stay");
        Assert.Null(shell.Leaving);
        Assert.Equal((0, true), (closed, shell.IsFree));

        Assert.True(here.Seat.User.StaysOpen());
        here.Seat.Tap("leaving-close");
        Assert.Equal(1, closed);
    });

    [Fact]
    public Task Without_changes_nothing_is_asked() => SetupSeat.AtAsync("points", here =>
    {
        Assert.False(here.Seat.User.StaysOpen());
        Assert.Null(here.Shell.Leaving);
    });
}
