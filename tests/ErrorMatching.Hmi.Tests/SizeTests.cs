using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Every side of every screen at other sizes, scalings and heights of what is touched than the pictures have:
/// measured, not pictured.</summary>
[Trait("Length", "Long")]
public sealed class SizeTests
{
    private const int Tries = 200;

    /// <summary>What screens measure: size in units of a screen of so many pixels at a scaling,
    /// with targets as they are or as large as they get.</summary>
    [Theory]
    [InlineData(1.0, 3840, 2160, TouchSize.Standard)]
    [InlineData(1.5, 1280, 720, TouchSize.Standard)]
    [InlineData(2.0, 1920, 1080, TouchSize.Standard)]
    [InlineData(1.0, 1280, 800, TouchSize.Largest)]
    [InlineData(1.5, 1280, 720, TouchSize.Largest)]
    public async Task Everything_is_seen_at_any_scaling_and_with_the_largest_targets(
        double scaling, double width, double height, TouchSize size)
    {
        await Drawing.Needed().RunAsync(() => OffScreenSession.Scaling = scaling);
        try
        {
            await Seat.AtAsync(
                seat =>
                {
                    seat.Shell.Preferences.TouchSize = size;
                    Measure(seat, $"{width}x{height} at {scaling * 100:0} %, {size}");
                },
                new(width, height));
        }
        finally
        {
            await Drawing.Needed().RunAsync(() => OffScreenSession.Scaling = 1);
        }
    }

    private static void Measure(Seat seat, string at)
    {
        var (problems, tries) = (new List<string>(), Tries);
        new Tour(seat).Deliver().Around(name =>
        {
            foreach (var language in Enum.GetValues<Language>())
            {
                Texts.Current.Language = language;
                seat.User.Settle();
                problems.AddRange(Lasting(seat, ref tries).Select(p => $"{name}, {at}, {language}: {p}"));
            }

            Texts.Current.Language = Language.English;
        });
        Assert.True(problems.Count == 0, string.Join('\n', problems.Distinct()));
    }

    // What is still being read and laid out is measured again; not without end on a tour that finds something everywhere.
    private static IReadOnlyList<string> Lasting(Seat seat, ref int tries)
    {
        var found = Layout.Problems(seat.Window);
        for (; tries > 0 && found.Count > 0; tries--)
        {
            seat.User.Wait(TimeSpan.FromMilliseconds(100));
            found = Layout.Problems(seat.Window);
        }

        return found;
    }
}
