using Avalonia;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.Diagnostics;
using Avalonia.LogicalTree;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A screen comes part by part, and whoever presses a key goes before what is left of it.</summary>
public sealed class UnfoldingTests
{
    [Fact]
    public Task Parts_come_one_by_one_the_outer_ones_first_and_small_ones_with_what_they_stand_in() => Drawing.Needed().RunAsync(() =>
    {
        var (hidden, first, second) = (new TextBlock { IsVisible = false }, new TextBlock(), new TextBlock());
        var inner = new StackPanel { Children = { first, second, hidden } };
        var view = new UserControl { Content = new Panel { Children = { new Border { Child = inner }, new TextBlock() } } };
        var unfolding = new Unfolding(view, 3);
        Assert.False(first.IsEffectivelyVisible);

        // The panel of three texts lies in the border, which has four controls within; no text has any.
        Assert.IsType<Border>(unfolding.Coming);
        unfolding.Next();
        Assert.Null(unfolding.Coming);
        Assert.Equal((true, true, false), (first.IsEffectivelyVisible, second.IsEffectivelyVisible, hidden.IsEffectivelyVisible));

        unfolding = new Unfolding(view, 0);
        var seen = new List<int>();
        while (unfolding.Coming is not null)
        {
            unfolding.Next();
            seen.Add(new[] { first, second, hidden }.Count(t => t.IsEffectivelyVisible));
        }

        Assert.Equal([0, 1, 2, 2, 2], seen);
    });

    [Theory]
    [InlineData(ScreenKeys.Points)]
    [InlineData(ScreenKeys.System)]
    [InlineData(ScreenKeys.Messages)]
    public Task A_key_is_taken_before_all_of_a_screen_is_there(string screen) => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter);
        var host = seat.Window.GetVisualDescendants().OfType<ScreenHost>().First();
        var grown = new List<int>();
        host.LayoutUpdated += (_, _) => grown.Add(Seen());
        int? atKey = null;
        seat.Shell.Go(screen);
        Dispatcher.UIThread.Post(() => atKey = Seen(), DispatcherPriority.Input);
        seat.User.Settle(10);
        var all = Seen();
        Assert.True(atKey < all / 3, $"{atKey} of {all} were there at the key.");
        Assert.True(grown.Distinct().Count() >= 5, $"They came by {string.Join(", ", grown)}.");
        Assert.DoesNotContain(
            host.GetVisualDescendants().OfType<Control>(),
            c => c.GetDiagnostic(Visual.IsVisibleProperty).Priority == BindingPriority.Animation);

        int Seen() => host.GetLogicalDescendants().OfType<Control>().Count(c => c.IsEffectivelyVisible);
    });
}
