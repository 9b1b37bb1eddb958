using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Long work shows that it goes on, and can be cancelled; what is over is not shown.</summary>
public sealed class WorkingTests
{
    [Fact]
    public Task Work_is_shown_while_it_goes_on_and_cancelled_by_a_tap() => Drawing.Needed().RunAsync(() =>
    {
        var isCancelled = false;
        var work = new LongCommand(async cancellation =>
        {
            try
            {
                await Task.Delay(Timeout.Infinite, cancellation);
            }
            finally
            {
                isCancelled = cancellation.IsCancellationRequested;
            }
        });
        var window = new Window { Width = 600, Height = 200, Content = new ContentControl { Content = work } };
        window.Show();
        try
        {
            var user = new ScreenUser(window).Settle();
            Assert.Null(Find("working"));
            work.Execute(null);
            user.Settle();
            Assert.True(Find("working") is ProgressBar { IsIndeterminate: true });
            Assert.False(work.CanExecute(null));
            user.Click(Find("working-cancel")!).WaitFor(() => !work.IsRunning, Seat.Patience);
            Assert.True(isCancelled);
            Assert.Null(Find("working"));
            Assert.True(work.CanExecute(null));
        }
        finally
        {
            window.Close();
        }

        Control? Find(string id) => window.GetVisualDescendants()
            .OfType<Control>()
            .FirstOrDefault(c => c.IsEffectivelyVisible && AutomationProperties.GetAutomationId(c) == id);
    });
}
