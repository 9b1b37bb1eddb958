using Avalonia;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Every side of every screen at other sizes, scalings and heights of what is touched than the pictures have:
/// measured, not pictured.</summary>
[Trait("Length", "Long")]
public sealed class SizeTests
{
    private const int Tries = 200;

    // What screens measure: units of a screen of so many pixels at a scaling, with targets as they are or as large as they get.
    private static readonly Dictionary<double, (Size Size, TouchSize Touch)[]> Screens = new()
    {
        [1.0] = [(new(1280, 800), TouchSize.Largest), (new(3840, 2160), TouchSize.Standard)],
        [1.5] = [(new(1280, 720), TouchSize.Standard), (new(1280, 720), TouchSize.Largest)],
        [2.0] = [(new(1920, 1080), TouchSize.Standard)],
    };

    // One tour for each scaling: going around takes longer than looking.
    [Theory]
    [InlineData(1.0, Explicit = true)]
    [InlineData(1.5)]
    [InlineData(2.0, Explicit = true)]
    public async Task Everything_is_seen_at_any_scaling_and_with_the_largest_targets(double scaling)
    {
        await Drawing.Needed().RunAsync(() => OffScreenSession.Scaling = scaling);
        try
        {
            await Seat.AtAsync(seat => Measure(seat, scaling, Screens[scaling]), Screens[scaling][0].Size);
        }
        finally
        {
            await Drawing.Needed().RunAsync(() => OffScreenSession.Scaling = 1);
        }
    }

    private static void Measure(Seat seat, double scaling, (Size Size, TouchSize Touch)[] screens)
    {
        var (problems, tries) = (new List<string>(), Tries);
        new Tour(seat).Deliver().Around(name =>
        {
            foreach (var (size, touch) in screens)
            {
                Show(size, touch);
                foreach (var language in Enum.GetValues<Language>())
                {
                    Texts.Current.Language = language;
                    seat.User.Settle();
                    var at = $"{size.Width}x{size.Height} at {scaling * 100:0} %, {touch}";
                    problems.AddRange(Lasting(seat, ref tries).Select(p => $"{name}, {at}, {language}: {p}"));
                }
            }

            Texts.Current.Language = Language.English;
            Show(screens[0].Size, screens[0].Touch);
        });
        Assert.True(problems.Count == 0, string.Join('\n', problems.Distinct()));

        void Show(Size size, TouchSize touch)
        {
            if (size != new Size(seat.Window.Width, seat.Window.Height))
            {
                (seat.Window.Width, seat.Window.Height) = (size.Width, size.Height);
            }

            seat.Shell.Preferences.TouchSize = touch;
            seat.User.Settle();
        }
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
