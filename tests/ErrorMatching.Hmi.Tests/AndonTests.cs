using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The overview for a wall.</summary>
public sealed class AndonTests
{
    // A letter of 25 mm is read from five meters (a two-hundredth of the distance). A capital has 0.7 of the size of the text, and a
    // screen of 43 inches is 535 mm high at 16:9, 579 mm at 16:10.
    private const double LeastMm = 25, Capital = 0.7;

    [Theory]
    [InlineData(1920, 1080, 535)]
    [InlineData(1280, 800, 579)]
    public Task It_says_how_the_cell_is_without_sign_in_and_large_enough(
        int width, int height, double highMm) => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Station.State.Status is { IsRunning: true, Proposed.Count: 1 }, "The cell is not seen.");
        using var overview = new OverviewViewModel(seat.Station, null, null, null, null);
        var window = new AndonWindow { IsDark = true, DataContext = overview, Width = width, Height = height };
        try
        {
            window.Show();
            new ScreenUser(window).Settle();
            Assert.Equal(
                ("Sample cell", "0", "1", "0"),
                (Said("andon-cell"), Said("andon-alarms"), Said("andon-approvals"), Said("andon-on-their-way")));
            Assert.Equal(Shown.TimeOfDay(seat.Clock.GetUtcNow(), seat.Clock), Said("andon-time"));
            var texts = window.GetVisualDescendants().OfType<TextBlock>().Where(t => t.Text?.Length > 0).ToArray();
            Assert.Contains(texts, t => t.Text == "vmc1/A");
            Assert.All(
                texts,
                t =>
                {
                    var seen = new Rect(t.Bounds.Size).TransformToAABB(t.TransformToVisual(window)!.Value);
                    Assert.True(new Rect(0, 0, width, height).Inflate(0.5).Contains(seen), $"\"{t.Text}\" is outside: {seen}.");
                    var scale = t.TransformToVisual(window)!.Value.M11;
                    Assert.InRange(t.FontSize * scale * Capital * highMm / height, LeastMm, double.MaxValue);
                });
            Assert.Empty(window.GetVisualDescendants().OfType<Button>());
        }
        finally
        {
            window.Close();
        }

        string? Said(string id) => window.GetVisualDescendants().OfType<TextBlock>()
            .Single(t => AutomationProperties.GetAutomationId(t) == id).Text;
    });
}
