using Avalonia.Controls;
using Avalonia.Layout;
using Avalonia.VisualTree;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

public sealed class LaterTests
{
    [Theory]
    [InlineData(false, false)]
    [InlineData(true, false)]
    [InlineData(false, true)]
    public Task Rows_of_a_list_box_come_a_few_at_a_time_until_all_that_are_seen_are_there(bool isHiddenFirst, bool areReadFirst) =>
        Drawing.Needed().RunAsync(() =>
    {
        var list = new ListBox();
        var cover = new Panel { Children = { list }, IsVisible = !isHiddenFirst };
        var window = new Window { Width = 300, Height = 400, Content = cover };
        var made = new List<int>();
        list.LayoutUpdated += (_, _) => made.Add(list.GetVisualDescendants().OfType<ListBoxItem>().Count());
        try
        {
            window.Show();
            var user = new ScreenUser(window).Settle();
            var rows = new RowList<int>();
            Later.SetRows(list, areReadFirst ? rows : Enumerable.Range(0, 100).ToArray());
            user.Settle(10);
            if (areReadFirst)
            {
                Assert.DoesNotContain(made, m => m > 0);
                rows.Show([.. Enumerable.Range(0, 100)]);
                user.Settle(10);
            }

            if (isHiddenFirst)
            {
                Assert.Null(list.ItemsSource);
                cover.IsVisible = true;
                user.Settle(10);
            }

            int[] steps = [.. made.Where(m => m > 0).Distinct()];
            Assert.True(steps.Length >= 3, $"They came by {string.Join(", ", steps)}.");
            Assert.Equal(steps.Order(), steps);
            Assert.True(steps[0] < steps[^1] / 2, $"They came by {string.Join(", ", steps)}.");
            Assert.True(list.GetVisualDescendants().OfType<ListBoxItem>().Sum(i => i.Bounds.Height) >= 400, "The list is not full.");
            Assert.Equal((double.PositiveInfinity, VerticalAlignment.Stretch), (list.MaxHeight, list.VerticalAlignment));
        }
        finally
        {
            window.Close();
        }
    });

    [Fact]
    public Task What_wants_the_focus_gets_it_once_it_is_seen() => Drawing.Needed().RunAsync(() =>
    {
        var (field, other) = (new TextBox(), new TextBox());
        var cover = new Panel { Children = { field }, IsVisible = false };
        var window = new Window { Width = 300, Height = 400, Content = new StackPanel { Children = { other, cover } } };
        try
        {
            window.Show();
            var user = new ScreenUser(window).Settle();
            Later.Focus(other);
            Assert.True(other.IsFocused);
            Later.Focus(field);
            user.Settle();
            Assert.True(other.IsFocused);
            cover.IsVisible = true;
            user.Settle();
            Assert.True(field.IsFocused);

            // Once only: whoever went on stays there.
            other.Focus();
            field.Width = 100;
            user.Settle();
            Assert.True(other.IsFocused);
        }
        finally
        {
            window.Close();
        }
    });
}
