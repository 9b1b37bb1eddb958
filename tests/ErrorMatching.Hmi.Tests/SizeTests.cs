using ErrorMatching.Cell;
using ErrorMatching.Hmi.Cairo;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Every screen at other sizes, scalings and heights of what is touched than the pictures have: measured, not pictured.</summary>
public sealed class SizeTests
{
    private const int Tries = 50;

    /// <summary>What screens measure: size in units of a screen of so many pixels at a scaling.</summary>
    [Theory]
    [InlineData(1.0, 3840, 2160)]
    [InlineData(1.5, 1280, 720)]
    [InlineData(2.0, 1920, 1080)]
    public async Task No_text_is_cut_off_at_any_scaling(double scaling, double width, double height)
    {
        await Drawing.Needed().RunAsync(() => OffScreenSession.Scaling = scaling);
        try
        {
            await Seat.AtAsync(seat => Measure(seat, $"{width}x{height} at {scaling * 100:0} %"), new(width, height));
        }
        finally
        {
            await Drawing.Needed().RunAsync(() => OffScreenSession.Scaling = 1);
        }
    }

    [Fact]
    public Task No_text_is_cut_off_when_what_is_touched_is_largest() => Seat.AtAsync(seat =>
    {
        seat.Shell.Preferences.TouchSize = TouchSize.Largest;
        Measure(seat, "largest targets");
    });

    // What is still being read and laid out is measured again.
    private static IReadOnlyList<string> Lasting(Seat seat)
    {
        for (var i = 0; i < Tries && Layout.Problems(seat.Window).Count > 0; i++)
        {
            seat.User.Wait(TimeSpan.FromMilliseconds(100));
        }

        return Layout.Problems(seat.Window);
    }

    private static void Measure(Seat seat, string at)
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Shell.Banner is null && seat.Station.State.Status?.Proposed.Count == 1, "The cell is not seen to run.");
        var problems = new List<string>();
        Look("login");
        seat.SignIn(DemoCell.Administrator);
        foreach (var item in seat.Shell.Items)
        {
            seat.Shell.Chosen = item;
            Look(item.Screen.Key);
        }

        Assert.True(problems.Count == 0, string.Join('\n', problems.Distinct()));

        void Look(string name)
        {
            foreach (var language in Enum.GetValues<Language>())
            {
                Texts.Current.Language = language;
                seat.User.Settle();
                problems.AddRange(Lasting(seat).Select(p => $"{name}, {at}, {language}: {p}"));
            }
        }
    }
}
