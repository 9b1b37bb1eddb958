using Avalonia.Input;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Whoever goes by keyboard stays where they are while rows are shown anew around them.</summary>
public sealed class FocusTests
{
    [Theory]
    [InlineData("nav-overview", "waiting-1")]
    [InlineData("nav-overview", "slot-vmc1/A")]
    [InlineData("nav-compensation", "correction-1")]
    [InlineData("nav-history", "found-1")]
    public Task The_focus_stays_in_a_row_that_says_something_else(string screen, string row) => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter);
        seat.WaitFor(() => seat.Station.State.Status?.Proposed.Count == 1, "The cell is not seen.");
        seat.Tap(screen);
        var before = seat.See(row);
        Assert.True(before.Focus(NavigationMethod.Tab));
        Texts.Current.Language = Language.TraditionalChinese;
        seat.User.Settle();
        Assert.True(seat.See(row).IsFocused, $"{(seat.See(row) == before ? "The same" : "Another")} control is there.");
    });
}
