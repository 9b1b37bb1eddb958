using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>No message moves a target: what is about to be tapped stays where it is, whatever is said.</summary>
[Trait("Length", "Long")]
public sealed class TargetTests
{
    [Theory]
    [InlineData(1, Explicit = true)]
    [InlineData(2)]
    public async Task No_message_of_the_cell_moves_a_target_on_any_screen(double scaling)
    {
        await Drawing.Needed().RunAsync(() => OffScreenSession.Scaling = scaling);
        try
        {
            await Seat.AtAsync(Around);
        }
        finally
        {
            await Drawing.Needed().RunAsync(() => OffScreenSession.Scaling = 1);
        }
    }

    private static void Around(Seat seat)
    {
        var moved = new List<string>();
        new Tour(seat).Deliver();
        Look(seat, "login", moved);
        seat.SignIn(DemoCell.Administrator);
        foreach (var screen in seat.Shell.Items.Select(i => i.Screen))
        {
            seat.Tap(screen.AutomationId);
            if (screen.Key is ScreenKeys.Points or ScreenKeys.System)
            {
                new SetupSeat(seat).Settle();
            }

            seat.User.Settle();
            Look(seat, screen.Key, moved);
        }

        Assert.True(moved.Count == 0, string.Join('\n', moved.Distinct()));
    }

    [Fact]
    public Task A_store_that_goes_moves_no_target_and_no_screen_says_that_there_is_nothing() => Seat.AtAsync(seat =>
    {
        string[] nothing = ["Freeform.Empty", "Verify.Empty", "Compensation.Empty", "Messages.Quiet", "Overview.Well"];
        var found = new List<string>();
        seat.RunCell().SignIn(DemoCell.Administrator);
        foreach (var item in seat.Shell.Items)
        {
            seat.Tap(item.Screen.AutomationId).WaitFor(() => seat.Shell.Chosen == item, "The screen does not open.");
            if (item.Screen.Key is ScreenKeys.Points or ScreenKeys.System)
            {
                new SetupSeat(seat).Settle();
            }

            seat.User.Settle();
            var before = Targets(seat);
            LostConnectionTests.Move(seat, "", ".away");
            seat.WaitFor(() => seat.Station.State.StoreTrouble is not null, "Nobody sees that the store is away.").User.Settle();
            found.AddRange(Moved(seat, before).Select(m => $"{item.Screen.Key}: moves {m}"));
            found.AddRange(Said($"{item.Screen.Key}"));

            // Opened while it is away.
            seat.Tap("nav-settings").Tap(item.Screen.AutomationId);
            seat.WaitFor(() => seat.Shell.Chosen == item, "The screen does not open again.");
            seat.User.Settle();
            found.AddRange(Said($"{item.Screen.Key} opened"));
            LostConnectionTests.Move(seat, ".away", "");

            // The cell itself pauses for seconds before it goes on; that nothing moves for what it says meanwhile is another test's.
            seat.WaitFor(() => seat.Station.State.StoreTrouble is null, "Nobody sees that the store is back.");
        }

        // Where it is known, it is said.
        seat.Tap("nav-freeform").See("freeform-empty");
        Assert.True(found.Count == 0, string.Join('\n', found));

        IEnumerable<string> Said(string where)
        {
            foreach (var language in Enum.GetValues<Language>().Reverse())
            {
                Texts.Current.Language = language;
                seat.User.Settle();
                var texts = seat.Window.GetVisualDescendants().OfType<TextBlock>();
                var shown = texts.Where(t => t.IsEffectivelyVisible).Select(t => t.Text).ToHashSet();
                foreach (var key in nothing.Where(k => shown.Contains(Texts.Current[k])))
                {
                    yield return $"{where} {language}: says {key}";
                }
            }
        }
    });

    /// <summary>Everything that a station can show, wherever it says something by itself, says too much there.</summary>
    [Fact]
    public Task Nothing_that_a_screen_says_moves_a_target_of_it() => Seat.AtAsync(seat =>
    {
        var (moved, said) = (new List<string>(), new HashSet<string>(StringComparer.Ordinal));
        new Tour(seat).Deliver().Around(stop =>
        {
            // The higher the targets the less room, and each script has lines of its own.
            (TouchSize, Language)[] looks = [(TouchSize.Largest, Language.TraditionalChinese), (TouchSize.Standard, Language.English)];
            foreach (var (touch, language) in looks)
            {
                (seat.Shell.Preferences.TouchSize, Texts.Current.Language) = (touch, language);
                seat.User.Settle();
                var (before, tries) = (Targets(seat), 3);
                Assert.NotEmpty(before);
                said.UnionWith(Saying(seat).Select(AutomationProperties.GetAutomationId).OfType<string>());

                // What is still being read in another language moves by itself, once.
                while (Moves(seat, before, Saying(seat)).Length > 0 && tries-- > 0)
                {
                    seat.User.Wait(TimeSpan.FromMilliseconds(100));
                    before = Targets(seat);
                }

                if (tries < 0)
                {
                    moved.AddRange(Saying(seat).SelectMany(one => Moves(seat, before, [one])
                        .Select(m => $"{stop} {touch} {language}: {AutomationProperties.GetAutomationId(one)} moves {m}")));
                }
            }
        });
        Assert.True(moved.Count == 0, string.Join('\n', moved.Distinct()));
        string[] known =
        [
            "setup-notice", "setup-message", "setup-kept", "users-message", "users-problem", "connections-message", "connections-progress",
            "history-message", "history-failed", "history-exported", "messages-message", "alarms-message",
            "audit-finding", "audit-wrong-day", "working", "signing-message",
            "login-message", "compensation-message", "compensation-undone", "compensation-next", "forbidden", "freeform-message",
            "verification-message", "chooser-message", "program-message", "detail-changed-job",
        ];
        Assert.Empty(known.Except(said));
    });

    /// <summary>In each field of each side something is typed that cannot be meant, and nothing at all;
    /// in each choice everything is chosen.</summary>
    [Theory]
    [InlineData(ScreenKeys.Points, TouchSize.Standard, Explicit = true)]
    [InlineData(ScreenKeys.System, TouchSize.Standard, Explicit = true)]
    [InlineData(ScreenKeys.Points, TouchSize.Largest)]
    [InlineData(ScreenKeys.System, TouchSize.Largest)]
    public Task Nothing_that_is_said_of_a_field_moves_a_target(string screen, TouchSize touch) => SetupSeat.AtAsync(screen, here =>
    {
        var (seat, editing, moved, tried) = (
            here.Seat, here.Shell.Editing, new List<string>(), new HashSet<string>(StringComparer.Ordinal));
        seat.Shell.Preferences.TouchSize = touch;

        // A row of each kind, and what is empty is told too.
        editing.Change("", d => d.With("$.toleranceChain[0].name", "cover")
            .With("$.toleranceChain[0].nominalMm", "15")
            .With("$.toleranceChain[0].toleranceMm[0]", "-0.1")
            .With("$.toleranceChain[0].toleranceMm[1]", "0.1").Without("$.verify")
            .With("$.verify[0].name", "a")
            .With("$.verify[0].quantity", "angle")
            .With("$.verify[0].between", "L1, L1"));
        here.Settle();
        editing.Report();
        seat.Tap("nav-" + screen);
        var sample = editing.Draft;
        string[] sides = screen == ScreenKeys.Points
            ? [""]
            : ["side-coordinates", "side-blocks", "side-tolerances", "side-machine", "side-gauge"];
        foreach (var side in sides)
        {
            if (side.Length > 0)
            {
                seat.Tap(side);
            }

            here.Settle();
            foreach (var id in Targets(seat).Keys.Where(k => k.StartsWith("edit-", StringComparison.Ordinal)).ToArray())
            {
                // In a long list, rows far from what is looked at are not there.
                if (seat.Find(id) is not { } field || !field.Focus())
                {
                    continue;
                }

                here.Settle();
                var before = Targets(seat);
                foreach (var (name, mistake) in Mistakes((SetupViewModel)seat.Shell.Current!, id))
                {
                    mistake();
                    here.Settle();
                    if (editing.Problems.Count > 0 && Targets(seat).Keys.ToHashSet().SetEquals(before.Keys))
                    {
                        _ = tried.Add(id);
                        moved.AddRange(Moved(seat, before).Select(m => $"{side} {touch}: \"{name}\" in {id} moves {m}"));
                    }

                    editing.Typed = null;
                    editing.Change("", _ => sample);
                    here.Settle();
                }
            }
        }

        Assert.True(moved.Count == 0, string.Join('\n', moved));
        Assert.InRange(tried.Count, screen == ScreenKeys.Points ? 5 : 40, 200);
    });

    private static IEnumerable<(string Name, Action Mistake)> Mistakes(SetupViewModel setup, string id) => setup.FieldOf(id) switch
    {
        TextField text => [("?!", () => text.Text = "?!"), ("", () => text.Text = "")],
        ChoiceField choice => choice.Items.Where(i => i != choice.Chosen).Select(i => (i.Word, (Action)(() => choice.Chosen = i))),
        _ => [],
    };

    [Theory]
    [InlineData("nav-verification", "piece-", "verification-mating")]
    [InlineData("nav-freeform", "surface-", "freeform-job")]
    public Task A_choice_that_comes_with_a_second_job_moves_no_row(string screen, string row, string choice) => Seat.AtAsync(seat =>
    {
        new Tour(seat).Deliver();
        seat.SignIn(DemoCell.Setter).Tap(screen);
        seat.WaitFor(() => Targets(seat).Keys.Any(k => k.StartsWith(row, StringComparison.Ordinal)), "There is no row.");
        var before = Targets(seat);
        Assert.DoesNotContain(choice, before.Keys);
        var box = seat.Window.GetVisualDescendants().OfType<ComboBox>().Single(c => AutomationProperties.GetAutomationId(c) == choice);
        using var shown = box.SetValue(Visual.IsVisibleProperty, true, BindingPriority.Animation);
        seat.User.Settle();
        Assert.Contains(choice, Targets(seat).Keys);
        Assert.Empty(Moved(seat, before));
    });

    // What comes by itself or after a tap, and is not there yet: a screen reader reads it out, or it shows progress.
    private static Control[] Saying(Seat seat) => [.. seat.Window.GetVisualDescendants().OfType<Control>()
        .Where(c => c is ProgressBar || (c is TextBlock && AutomationProperties.GetLiveSetting(c) != AutomationLiveSetting.Off))
        .Where(
            c => !seat.Window.Stage.IsVisualAncestorOf(c)
                && HiddenWith(c).All(h => !h.Classes.Contains("page") && !h.Classes.Contains("veil")))
        .Where(
            c => HiddenWith(c) is [.., var outer]
                ? outer.GetVisualParent() is Control { IsEffectivelyVisible: true }
                : c is TextBlock { Text: null or "" })];

    // Itself and what stands around it and is hidden with it.
    private static List<Control> HiddenWith(Control control)
    {
        var chain = control.GetSelfAndVisualAncestors().OfType<Control>().ToList();
        return chain.FindLastIndex(c => !c.IsVisible) is >= 0 and var last ? chain.GetRange(0, last + 1) : [];
    }

    // Where each says more than there is room for, with the buttons that may come with it.
    private static string[] Moves(Seat seat, Dictionary<string, Rect> before, IReadOnlyList<Control> saying)
    {
        var words = string.Join(' ', Enumerable.Repeat("something is not as it should be", 20));
        var shown = new List<IDisposable?>();
        foreach (var one in saying)
        {
            var strip = one.GetVisualAncestors().OfType<Control>().FirstOrDefault(c => c.Classes.Contains("line"));
            Control[] buttons = strip is null ? [] : [.. strip.GetVisualDescendants().OfType<Button>().Where(b => !b.IsVisible)];
            shown.AddRange(
                HiddenWith(one).Concat(buttons).Select(c => c.SetValue(Visual.IsVisibleProperty, true, BindingPriority.Animation)));
            if (one is TextBlock text)
            {
                shown.Add(text.SetValue(TextBlock.TextProperty, words, BindingPriority.Animation));
            }
        }

        seat.User.Settle();
        var moved = Moved(seat, before).ToArray();
        shown.ForEach(s => s?.Dispose());
        seat.User.Settle();
        return moved;
    }

    // Each kind of message in both languages, with the smallest and the largest targets, compared with where each target is with none.
    private static void Look(Seat seat, string screen, List<string> moved)
    {
        var calm = seat.Station.State;
        foreach (var touch in new[] { TouchSize.Standard, TouchSize.Largest })
        {
            seat.Shell.Preferences.TouchSize = touch;
            foreach (var language in Enum.GetValues<Language>())
            {
                Texts.Current.Language = language;

                // The figures of a surface, and what a correction warns of, are put into words in the background, and other words take
                // other room.
                seat.WaitFor(
                    () => seat.Find("surface-verdict") is null || IsIn(language, seat.TextOf("surface-verdict")!),
                    "The surface stays in another language.");
                seat.WaitFor(
                    () => seat.Find("detail-warnings") is not { IsEffectivelyVisible: true } warnings
                        || IsIn(language, AutomationProperties.GetName(warnings) ?? ""),
                    "The correction stays in another language.");
                Show(seat, calm, null);
                var before = Targets(seat);
                Assert.NotEmpty(before);
                foreach (var (name, state, notice) in Messages(calm))
                {
                    Show(seat, calm, null);
                    seat.Clock.Advance(AimKeeper.OnItsWay);
                    Show(seat, state, notice);
                    Assert.NotNull(seat.Find(notice is null ? "banner" : "notice"));
                    moved.AddRange(Moved(seat, before).Select(m => $"{screen} {touch} {language}: {name} moves {m}"));
                }

                Show(seat, calm, null);
            }
        }

        seat.Shell.Preferences.TouchSize = TouchSize.Standard;
        Texts.Current.Language = Language.English;
        seat.User.Settle();
    }

    private static bool IsIn(Language language, string text) =>
        text.Any(c => c >= '\u4E00') == (language == Language.TraditionalChinese);

    private static IEnumerable<(string Name, StationState State, string? Notice)> Messages(StationState calm)
    {
        var (status, words) = (calm.Status!, string.Join(' ', Enumerable.Repeat("something is not as it should be", 12)));
        var slot = CellTrouble.OfSlot("vmc1", "A");
        var trouble = new CellTrouble(slot, CellCodes.Of(TransportError.Denied), words, DateTimeOffset.UnixEpoch);
        yield return ("a store that is away", calm with { StoreTrouble = new StoreException(StoreError.Away, "away") }, null);
        yield return ("a cell that stands", calm with { Status = status with { IsRunning = false } }, null);
        yield return ("a trouble", With(trouble), null);
        yield return ("troubles", With(trouble, trouble with { Where = "store", Code = CellCodes.NotKept }), null);
        yield return ("a notice", calm, words);

        StationState With(params CellTrouble[] troubles) =>
            calm with { Status = status with { Heartbeat = status.Heartbeat! with { Troubles = troubles } } };
    }

    private static void Show(Seat seat, StationState state, string? notice)
    {
        seat.Shell.Preferences.Notice = notice;
        seat.Station.Pretend(state);
        seat.User.Settle();
    }

    // A tile of a list may go on where a tap at the place that it left does nothing else. Nobody misses by two pixels: a line of
    // another script is as much higher.
    private static IEnumerable<string> Moved(Seat seat, Dictionary<string, Rect> before)
    {
        var now = Targets(seat);
        return before
            .Where(b => now.TryGetValue(b.Key, out var place) && Distance(place, b.Value) > 2)
            .Where(b => seat.Find(b.Key) is not Button tile || !TapKeeper.IsKept(tile) || IsTaken(seat, b.Key, b.Value.Center))
            .Select(b => $"{b.Key} from {b.Value} to {now[b.Key]}");
    }

    private static bool IsTaken(Seat seat, string id, Point place) =>
        seat.Window.InputHitTest(place) is Visual under && !seat.Window.Aim.IsMissed(under, place)
        && under.GetSelfAndVisualAncestors().OfType<Control>().FirstOrDefault(Layout.IsTouched) is { IsEffectivelyEnabled: true } other
        && AutomationProperties.GetAutomationId(other) != id;

    private static double Distance(Rect one, Rect two) => Math.Max(Math.Abs(one.X - two.X), Math.Abs(one.Y - two.Y));

    private static Dictionary<string, Rect> Targets(Seat seat) => seat.Window.GetVisualDescendants().OfType<Control>()
        .Where(c => c.IsEffectivelyVisible && Layout.IsTouched(c) && !Layout.IsPart(c) && !seat.Window.Stage.IsVisualAncestorOf(c))
        .Select(c => (Id: AutomationProperties.GetAutomationId(c), Place: Layout.In(c, seat.Window)))
        .Where(c => !string.IsNullOrEmpty(c.Id))
        .GroupBy(c => c.Id!, StringComparer.Ordinal)
        .ToDictionary(g => g.Key, g => g.First().Place, StringComparer.Ordinal);
}
