using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>In the smallest window that is allowed, with any targets, rows are seen, nothing lies over anything else, and what must be read
/// before a signature is read before it.</summary>
public sealed class LowWindowTests
{
    private static readonly string[] Sides = ["points", "counterpart", "features", "program", "decisions", "course"];

    // What is read before a decision on the screen of corrections: never behind an edge.
    private static readonly string[] Read = [
        "compensation-next", "forbidden", "detail-changed-job", "compensation-message", "compensation-undone"];

    private static readonly (Language Language, string Code)[] Languages = [(Language.TraditionalChinese, "zh"), (Language.English, "en")];

    [Theory]
    [InlineData(1024, 640, TouchSize.Standard, Explicit = true)]
    [InlineData(1024, 640, TouchSize.Largest)]
    [InlineData(1280, 800, TouchSize.Standard, Explicit = true)]
    public Task Rows_and_the_next_step_are_seen(double width, double height, TouchSize touch) => Seat.AtAsync(
        seat =>
        {
            var problems = new List<string>();
            seat.Cell.Run();
            seat.Cell.Deliver(1, 0);
            seat.WaitFor(1, CorrectionState.Proposed);
            new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
            seat.WaitFor(1, CorrectionState.Verified);
            seat.Cell.Deliver(2, 0.02);
            seat.WaitFor(2, CorrectionState.Proposed);
            seat.WaitFor(() => seat.Shell.Banner is null && seat.Station.State.Status?.Proposed.Count == 1, "The cell is not seen to run.");
            seat.Shell.Preferences.TouchSize = touch;
            Look("login");
            seat.SignIn(DemoCell.Operator);
            seat.Shell.Preferences.TouchSize = touch;
            Open(2);
            Look("operator, proposed");
            Open(1);
            Look("operator, at the machine");
            seat.Tap("sign-out");
            seat.WaitFor(() => seat.Shell.IsLocked, "It does not lock.");
            seat.SignIn(DemoCell.Setter);
            seat.Shell.Preferences.TouchSize = touch;
            Look("overview");
            Open(1);
            Look("at the machine");
            Open(2);
            foreach (var side in Sides)
            {
                seat.Tap("tab-" + side);
                Look(side);
            }

            // A dialog asks to be scrolled to its end as it opens: nobody changes the language while it is open.
            foreach (var language in Languages)
            {
                Texts.Current.Language = language.Language;
                seat.User.Settle();
                seat.Tap("approve").See("signing-password");
                Look("signing", language);
                seat.User.Press(Key.Escape);
                seat.Tap("reject").See("signing-reason");
                Look("rejecting", language);
                seat.User.Press(Key.Escape);
            }

            foreach (var (screen, id) in new[]
            {
                (ScreenKeys.Verification, "pair"), (ScreenKeys.History, "found-1"), (ScreenKeys.Messages, "message-2"),
                (ScreenKeys.Messages, "audit")
            })
            {
                seat.Shell.Go(screen);
                if (id == "audit")
                {
                    seat.Tap("tab-trail");
                }

                seat.See(id);
                Look(screen);
            }

            Assert.True(problems.Count == 0, string.Join('\n', problems.Distinct()));

            void Open(long id)
            {
                seat.Shell.Look(id);
                seat.WaitFor(
                    () => seat.Find("detail-title") is TextBlock { Text: { } title }
                        && title.StartsWith($"#{id} ", StringComparison.Ordinal),
                    "It is not shown.");
            }

            void Look(string name, (Language Language, string Code)? only = null)
            {
                foreach (var (language, code) in only is { } one ? [one] : Languages)
                {
                    Texts.Current.Language = language;
                    seat.User.Settle();
                    var (found, tries) = (Problems(seat, touch).ToArray(), 20);
                    while (found.Length > 0 && tries-- > 0)
                    {
                        seat.User.Wait(TimeSpan.FromMilliseconds(50));
                        found = [.. Problems(seat, touch)];
                    }

                    problems.AddRange(found.Select(p => $"{name} {width}x{height} {touch} {code}: {p}"));
                    seat.Shell.IsDark = code == "zh";
                    var file = $"low-{width}x{height}-{touch}-{name.Replace(", ", "-").Replace(' ', '-')}-{code}.png";
                    seat.User.Screenshot(Repository.PathTo("artifacts", "screenshots", file));
                }
            }
        },
        new(width, height));

    [Fact]
    public Task What_does_not_fit_is_scrolled_to_before_it_is_signed() => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter);
            var isDone = false;
            seat.Shell.Sign(new SigningViewModel(
                seat.Station, seat.Shell.Who!, Act.Approve, "#1", needsReason: false, (_, _, _) => Task.FromResult(isDone = true))
            {
                Known = () => [
                    .. Enumerable.Range(1, 40).Select(i => new Fact($"Something that must be known before, {i}.", Severity.Attention))],
            });
            seat.Type("signing-password", DemoCell.Password);
            Assert.NotNull(seat.See("signing-read-first"));
            Assert.False(seat.See("signing-confirm").IsEffectivelyEnabled);
            seat.User.Press(Key.Enter);
            Assert.False(isDone);
            var facts = (ScrollViewer)seat.See("signing-scroll");
            facts.ScrollToEnd();
            seat.User.Settle();
            Assert.Null(seat.Find("signing-read-first"));
            Assert.True(seat.See("signing-confirm").IsEffectivelyEnabled);

            // What was read once may be scrolled back to.
            facts.ScrollToHome();
            seat.User.Settle().Press(Key.Enter);
            seat.WaitFor(() => isDone, "It is not signed.");
        },
        new(1024, 640));

    private static IEnumerable<string> Problems(Seat seat, TouchSize touch)
    {
        var window = seat.Window;
        foreach (var problem in Layout.Problems(window).Where(p => p.Contains(" lie over ", StringComparison.Ordinal)
            || p.Contains(" leaves ", StringComparison.Ordinal)
            || p.Contains("clipped", StringComparison.Ordinal)
            || p.Contains("is scrolled to", StringComparison.Ordinal)))
        {
            yield return problem;
        }

        foreach (var list in window.GetVisualDescendants().OfType<ListBox>().Where(
            l => l.IsEffectivelyVisible && l.ItemCount > 0 && !window.Stage.IsVisualAncestorOf(l)))
        {
            var rows = list.GetVisualDescendants().OfType<ListBoxItem>().Count(
                r => r.IsEffectivelyVisible && Layout.Seen(r, window).Height >= Math.Min(r.Bounds.Height, 57) - 1);
            if (rows < Math.Min(list.ItemCount, 1))
            {
                yield return $"{AutomationProperties.GetAutomationId(list)} shows {rows} rows of {list.ItemCount}";
            }
        }

        foreach (var id in Read)
        {
            if (seat.Find(id) is TextBlock { Text.Length: > 0 } text && !IsWhole(text, window))
            {
                yield return $"{id} is cut off: {text.Text}";
            }
        }

        if (seat.Shell.Signing is { } signing && !signing.MustScroll)
        {
            foreach (var text in window.GetVisualDescendants().OfType<SigningView>().Single().GetVisualDescendants().OfType<TextBlock>()
                .Where(t => t.IsEffectivelyVisible && t.FindAncestorOfType<TextPresenter>() is null && !string.IsNullOrEmpty(t.Text)
                    && !IsWhole(t, window)))
            {
                yield return $"the dialog cuts off: {text.Text}";
            }
        }
    }

    private static bool IsWhole(Control control, Window window) =>
        Layout.Seen(control, window) is var seen && Layout.In(control, window) is var all
            && seen.Height >= all.Height - 1 && seen.Width >= all.Width - 1;
}
