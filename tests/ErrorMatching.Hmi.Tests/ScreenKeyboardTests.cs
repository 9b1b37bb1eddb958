using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Who has only fingers types with them, into a field that is never covered.</summary>
public sealed class ScreenKeyboardTests
{
    [Fact]
    public void Every_printable_character_of_ASCII_can_be_typed()
    {
        var typed = new[] { KeyboardLayout.Letters, KeyboardLayout.Signs }.SelectMany(l => l.Rows).SelectMany(r => r)
            .Where(k => k.Act is BoardAct.Type or BoardAct.Space)
            .SelectMany(k => new[] { k.Typed(isShifted: false), k.Typed(isShifted: true) })
            .ToHashSet();
        Assert.All(Enumerable.Range(' ', '~' - ' ' + 1), c => Assert.Contains(((char)c).ToString(), typed));
    }

    [Fact]
    public void Rows_are_equally_wide_and_layouts_equally_high()
    {
        Assert.All(
            new[] { KeyboardLayout.Letters, KeyboardLayout.Signs, KeyboardLayout.Numbers },
            l =>
            {
                Assert.Equal(KeyboardLayout.Letters.Rows.Count, l.Rows.Count);
                Assert.Single(l.Rows.Select(r => r.Sum(k => k.Width)).Distinct());
                Assert.Equal(l.Rows.Sum(r => r.Count), l.Rows.SelectMany(r => r).DistinctBy(k => k.AutomationId).Count());
            });
    }

    [Fact]
    public Task A_finger_signs_in_and_closes_the_keyboard() => Seat.AtAsync(seat =>
    {
        seat.See("login-users");
        Assert.Null(Board(seat));
        Finger(seat, "login-user-" + DemoCell.Setter);
        seat.See("key-a");
        Fingers(seat, DemoCell.Password);
        Finger(seat, "key-enter");
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        seat.WaitFor(() => Board(seat) is null, "The keyboard stays.");
        Assert.Equal(DemoCell.Setter, seat.Shell.UserName);
    });

    [Fact]
    public Task Each_key_does_what_it_says() => Seat.AtAsync(seat =>
    {
        var name = (TextBox)seat.See("login-name");
        Finger(seat, "login-name");
        seat.See("key-a");
        Fingers(seat, "ab");
        Finger(seat, "key-shift");
        Assert.Equal("C", (seat.See("key-c") as Button)?.Content is TextBlock caption ? caption.Text : null);
        Fingers(seat, "cd");
        Assert.Equal("abCd", name.Text);
        Finger(seat, "key-shift");
        Finger(seat, "key-shift");
        Fingers(seat, "ef");
        Finger(seat, "key-shift");
        Fingers(seat, "g");
        Assert.Equal("abCdEFg", name.Text);
        Finger(seat, "key-left");
        Finger(seat, "key-erase");
        Finger(seat, "key-right");
        Finger(seat, "key-space");
        Finger(seat, "key-signs");
        Fingers(seat, "#");
        Finger(seat, "key-numbers");
        Fingers(seat, "7.");
        Finger(seat, "key-letters");
        Fingers(seat, "z");
        Assert.Equal("abCdEg #7.z", name.Text);
        Finger(seat, "key-close");
        Assert.Null(Board(seat));

        // Who touches the field again wants it again.
        Finger(seat, "login-name");
        seat.See("key-a");
    });

    [Fact]
    public Task Two_neighboring_keys_may_follow_each_other_at_once() => Seat.AtAsync(seat =>
    {
        Finger(seat, "login-name");
        var (q, w) = (seat.See("key-q"), seat.See("key-w"));
        for (var i = 0; i < 3; i++)
        {
            seat.User.Tap(q, new Point(q.Bounds.Width - 4, q.Bounds.Height / 2)).Tap(w, new Point(4, w.Bounds.Height / 2));
        }

        Assert.Equal("qwqwqw", ((TextBox)seat.See("login-name")).Text);
    });

    [Fact]
    public Task A_mouse_or_another_keyboard_needs_none_unless_wanted() => Seat.AtAsync(seat =>
    {
        seat.User.Click(seat.See("login-name"));
        Assert.Null(Board(seat));
        Finger(seat, "login-name");
        seat.See("key-a");
        seat.User.Press(Key.X);
        Assert.Null(Board(seat));
        seat.Shell.Preferences.Keyboard = KeyboardUse.Always;
        seat.User.Click(seat.See("login-password"));
        seat.See("key-a");
        Finger(seat, "key-close");
        seat.Shell.Preferences.Keyboard = KeyboardUse.Never;
        Finger(seat, "login-password");
        Assert.Null(Board(seat));
    });

    [Fact]
    public Task What_the_cell_says_meanwhile_leaves_it_open() => Seat.AtAsync(seat =>
    {
        Finger(seat, "login-password");
        seat.See("key-a");
        seat.RunCell();
        Finger(seat, "language");
        seat.User.Settle();
        Finger(seat, "login-password");
        Assert.NotNull(Board(seat));
        Texts.Current.Language = Language.English;
        seat.User.Settle();
        Assert.NotNull(Board(seat));
    });

    [Fact]
    public Task A_station_that_locks_shows_none() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-history");
        Finger(seat, "history-serial");
        seat.See("key-a");
        Finger(seat, "sign-out");
        seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
        seat.User.Settle();
        Assert.Null(Board(seat));
    });

    [Theory]
    [InlineData(1280, 800, TouchSize.Standard)]
    [InlineData(1024, 768, TouchSize.Largest)]
    [Trait("Length", "Long")]
    public Task No_field_is_covered_and_numbers_get_digits(int width, int height, TouchSize size) => Seat.AtAsync(
        seat =>
        {
            var (covered, fields, digits) = (new List<string>(), 0, 0);
            new Tour(seat).Deliver().Around(stop =>
            {
                seat.Shell.Preferences.TouchSize = size;
                seat.User.Settle();
                foreach (var field in Fields(seat))
                {
                    seat.User.Settle();
                    if (field.TranslatePoint(new(4, field.Bounds.Height / 2), seat.Window) is not { } place
                        || (seat.Window.InputHitTest(place) as Visual)?.FindAncestorOfType<TextBox>(includeSelf: true) != field)
                    {
                        continue;
                    }

                    seat.User.Tap(field, new Point(4, field.Bounds.Height / 2));
                    if (Board(seat) is not { } board)
                    {
                        covered.Add($"{stop}: {Id(field)} opens none");
                        continue;
                    }

                    fields++;
                    digits += seat.Find("key-a") is null ? 1 : 0;
                    var (top, bottom) = (field.TranslatePoint(default, seat.Window)!.Value.Y,
                        field.TranslatePoint(new(0, field.Bounds.Height), seat.Window)!.Value.Y);
                    if (bottom > board.TranslatePoint(default, seat.Window)!.Value.Y || top < 0)
                    {
                        covered.Add($"{stop}: {Id(field)} from {top} to {bottom}");
                    }

                    Assert.All(
                        board.GetVisualDescendants().OfType<Button>(),
                        k => Assert.True(k.Bounds is { Width: >= 57, Height: >= 57 }, $"{Id(k)} {k.Bounds}"));

                    // Not by its key: a tap that follows at once near there would be taken for a second one.
                    seat.User.Press(Key.LeftCtrl);
                    Assert.Null(Board(seat));
                }
            });
            Assert.True(covered.Count == 0, string.Join('\n', covered));
            Assert.True(fields > 25, $"{fields} fields");
            Assert.True(digits > 15, $"{digits} fields for numbers");
        },
        new(width, height));

    private static TextBox[] Fields(Seat seat) =>
        [.. seat.Window.GetVisualDescendants().OfType<TextBox>()
            .Where(f => f.IsEffectivelyVisible && f.IsEffectivelyEnabled && !f.IsReadOnly && !seat.Window.Stage.IsVisualAncestorOf(f))];

    private static string? Id(Control control) => AutomationProperties.GetAutomationId(control);

    private static ScreenKeyboard? Board(Seat seat) =>
        seat.Window.GetVisualDescendants().OfType<ScreenKeyboard>().SingleOrDefault(b => b.IsEffectivelyVisible);

    private static void Finger(Seat seat, string id)
    {
        seat.User.Tap(seat.See(id));
        seat.User.Settle();
    }

    private static void Fingers(Seat seat, string text)
    {
        foreach (var c in text)
        {
            Finger(seat, "key-" + c);
        }
    }
}
