using Avalonia.Controls;
using Avalonia.Layout;
using Avalonia.VisualTree;
using ErrorMatching.Hmi.Cairo;

namespace ErrorMatching.Hmi.Tests;

public sealed class LaterTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task Rows_of_a_list_box_come_a_few_at_a_time_until_all_that_are_seen_are_there(bool isHiddenFirst) => Drawing.Needed().RunAsync(() =>
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
            Later.SetRows(list, Enumerable.Range(0, 100).ToArray());
            user.Settle(10);
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
}
