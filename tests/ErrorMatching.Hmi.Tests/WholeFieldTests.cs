using Avalonia;
using Avalonia.Controls;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Who taps a field writes a new value in the place of the old one;
/// who taps again, or draws over it, means a place in it.</summary>
public sealed class WholeFieldTests
{
    [Theory]
    [InlineData(false, false)]
    [InlineData(true, false)]
    [InlineData(false, true)]
    [InlineData(true, true)]
    public Task A_tap_into_a_field_takes_all_of_it(bool isTouch, bool isForm) => Drawing.Needed().RunAsync(() =>
    {
        var (window, user, first, second) = Make(isForm);
        try
        {
            Tap(user, first, 190, isTouch);
            user.Type("9");
            Assert.Equal("9", first.Text);

            // The second tap sets the caret: behind the last character here. It falls elsewhere, or it would be a double one.
            Tap(user, second, 190, isTouch);
            Assert.Equal("WO-2", second.SelectedText);
            Tap(user, second, 120, isTouch);
            user.Type("1");
            Assert.Equal("WO-21", second.Text);
        }
        finally
        {
            window.Close();
        }
    });

    [Fact]
    public Task What_is_drawn_over_is_taken_and_no_more() => Drawing.Needed().RunAsync(() =>
    {
        var (window, user, first, _) = Make(isForm: true);
        try
        {
            user.Drag(first, new(190, 20), new(25, 20));
            Assert.Equal(first.Text!.Length, first.SelectionStart);
            Assert.InRange(first.SelectionEnd, 1, first.Text.Length - 1);
        }
        finally
        {
            window.Close();
        }
    });

    private static void Tap(ScreenUser user, Visual field, double x, bool isTouch)
    {
        if (isTouch)
        {
            user.Swipe(field, new(x, 20), new(x, 20));
        }
        else
        {
            user.Click(field, new(x, 20));
        }

        user.Settle();
    }

    private static (Window Window, ScreenUser User, TextBox First, TextBox Second) Make(bool isForm)
    {
        var (first, second) = (new TextBox { Text = "0.05", Height = 57 }, new TextBox { Text = "WO-2", Height = 57 });
        if (isForm)
        {
            first.Theme = second.Theme = (Avalonia.Styling.ControlTheme)Application.Current!.FindResource("Field")!;
        }

        var window = new Window { Width = 200, Height = 200, Content = new StackPanel { Children = { first, second } } };
        window.Show();
        return (window, new ScreenUser(window).Settle(), first, second);
    }
}
