using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>No message moves a target: what is about to be tapped stays where it is, whatever is said.</summary>
[Trait("Length", "Long")]
public sealed class TargetTests
{
    [Fact]
    public Task No_message_of_the_cell_moves_a_target_on_any_screen() => Seat.AtAsync(seat =>
    {
        var moved = new List<string>();
        new Tour(seat).Deliver();
        Look(seat, "login", moved);
        seat.SignIn(DemoCell.Administrator);
        foreach (var screen in seat.Shell.Items.Select(i => i.Screen))
        {
            seat.Tap(screen.AutomationId);
            if (screen.Key is Screens.Points or Screens.System)
            {
                new SetupSeat(seat).Settle();
            }

            seat.User.Settle();
            Look(seat, screen.Key, moved);
        }

        Assert.True(moved.Count == 0, string.Join('\n', moved.Distinct()));
    });

    // Each kind of message in both languages, with the smallest and the largest targets; where each target is with none is what it is compared with.
    private static void Look(Seat seat, string screen, List<string> moved)
    {
        var calm = seat.Station.State;
        foreach (var touch in new[] { TouchSize.Standard, TouchSize.Largest })
        {
            seat.Shell.Preferences.TouchSize = touch;
            foreach (var language in Enum.GetValues<Language>())
            {
                Texts.Current.Language = language;
                Show(seat, calm, null);
                var before = Targets(seat);
                Assert.NotEmpty(before);
                foreach (var (name, state, notice) in Messages(calm))
                {
                    Show(seat, state, notice);
                    Assert.NotNull(seat.Find(notice is null ? "banner" : "notice"));
                    var now = Targets(seat);
                    moved.AddRange(before.Where(b => now.TryGetValue(b.Key, out var place) && Distance(place, b.Value) > 0.5)
                        .Select(b => $"{screen} {touch} {language}: {name} moves {b.Key} from {b.Value} to {now[b.Key]}"));
                }

                Show(seat, calm, null);
            }
        }

        seat.Shell.Preferences.TouchSize = TouchSize.Standard;
        Texts.Current.Language = Language.English;
        seat.User.Settle();
    }

    private static IEnumerable<(string Name, StationState State, string? Notice)> Messages(StationState calm)
    {
        var (status, words) = (calm.Status!, string.Join(' ', Enumerable.Repeat("something is not as it should be", 12)));
        var trouble = new CellTrouble(CellTrouble.OfSlot("vmc1", "A"), CellCodes.Of(TransportError.Denied), words, DateTimeOffset.UnixEpoch);
        yield return ("a store that is away", calm with { StoreTrouble = new StoreException(StoreError.Away, "away") }, null);
        yield return ("a cell that stands", calm with { Status = status with { IsRunning = false } }, null);
        yield return ("a trouble", With(trouble), null);
        yield return ("troubles", With(trouble, trouble with { Where = "store", Code = CellCodes.NotKept }), null);
        yield return ("a notice", calm, words);

        StationState With(params CellTrouble[] troubles) => calm with { Status = status with { Heartbeat = status.Heartbeat! with { Troubles = troubles } } };
    }

    private static void Show(Seat seat, StationState state, string? notice)
    {
        seat.Shell.Preferences.Notice = notice;
        seat.Station.Pretend(state);
        seat.User.Settle();
    }

    private static double Distance(Rect one, Rect two) => Math.Max(Math.Abs(one.X - two.X), Math.Abs(one.Y - two.Y));

    private static Dictionary<string, Rect> Targets(Seat seat) => seat.Window.GetVisualDescendants().OfType<Control>()
        .Where(c => c.IsEffectivelyVisible && Layout.IsTouched(c) && !Layout.IsPart(c) && !seat.Window.Stage.IsVisualAncestorOf(c))
        .Select(c => (Id: AutomationProperties.GetAutomationId(c), Place: Layout.In(c, seat.Window)))
        .Where(c => !string.IsNullOrEmpty(c.Id))
        .GroupBy(c => c.Id!, StringComparer.Ordinal)
        .ToDictionary(g => g.Key, g => g.First().Place, StringComparer.Ordinal);
}
