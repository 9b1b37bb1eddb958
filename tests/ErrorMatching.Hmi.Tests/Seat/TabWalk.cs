using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Threading;
using Avalonia.VisualTree;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A person who goes through what is on the screen by Tab alone, there and back:
/// what they do not get to, what they do not see, and where the way jumps.</summary>
internal sealed class TabWalk(Seat seat)
{
    // Nobody presses Tab so often: the way never comes back to where it began.
    private const int Most = 400;
    private const double Slack = 4;
    private readonly List<string> _problems = [];

    /// <summary>What is wrong, with the name of the screen.</summary>
    public IReadOnlyList<string> Problems => _problems;

    /// <summary>How often Tab was pressed.</summary>
    public int Stops { get; private set; }

    /// <summary>Goes once around.</summary>
    /// <param name="name">What is on the screen.</param>
    /// <param name="first">Where to begin; what has the focus if null.</param>
    public TabWalk Around(string name, string? first = "language")
    {
        var found = _problems.Count;
        seat.User.Settle();
        if (first is not null)
        {
            Assert.True(seat.See(first).Focus(NavigationMethod.Tab), $"{name}: {first} takes no focus.");
        }

        var way = Way(name, RawInputModifiers.None, isLooked: true);
        foreach (var missed in seat.Window.GetVisualDescendants().OfType<Control>().Where(c => IsMeant(c) && !way.Any(w => IsThere(w, c))))
        {
            _problems.Add($"{name}: Tab does not get to {Name(missed)}");
        }

        var back = Way(name, RawInputModifiers.Shift, isLooked: false);
        if (found == _problems.Count && !way.Skip(1).Reverse().Prepend(way[0]).SequenceEqual(back))
        {
            _problems.Add($"{name}: there by {string.Join(", ", way.Select(Name))}; back by {string.Join(", ", back.Select(Name))}");
        }

        return this;
    }

    private List<Control> Way(string name, RawInputModifiers modifiers, bool isLooked)
    {
        var way = new List<Control>();
        var (before, seen) = (default(PixelRect), Array.Empty<byte>());
        for (var at = Focused(); ; at = Focused())
        {
            if (at is null || way.Count > Most)
            {
                _problems.Add(
                    $"{name}: {(at is null ? "the focus is lost" : "the way does not end")} behind "
                        + $"{string.Join(", ", way.TakeLast(3).Select(Name))}");
                return way;
            }

            if (isLooked)
            {
                OffScreenClock.Current.Advance(2);
                if (way is [.., var last] && seen.AsSpan().SequenceEqual(Pixels(before)))
                {
                    _problems.Add($"{name}: the focus on {Name(last)} is not seen");
                }

                if (way is [.., var from] && at != way[0] && IsJump(from, at))
                {
                    _problems.Add($"{name}: the way jumps from {Name(from)} to {Name(at)}");
                }

                before = Around(at);
                seen = Pixels(before);
            }

            if (way.Count > 0 && at == way[0])
            {
                return way;
            }

            way.Add(at);
            Stops++;
            seat.Window.Platform().Key(Avalonia.Input.Raw.RawKeyEventType.KeyDown, Key.Tab, modifiers, 0);
            seat.Window.Platform().Key(Avalonia.Input.Raw.RawKeyEventType.KeyUp, Key.Tab, modifiers, 0);
            Dispatcher.UIThread.RunJobs(null);
        }
    }

    private Control? Focused() => seat.Window.FocusManager?.GetFocusedElement() as Control;

    // What a finger can do on the screen that is in front.
    private static bool IsMeant(Control control) =>
        control.IsEffectivelyVisible
            && control.IsEffectivelyEnabled
            && (Layout.IsTouched(control) || control is PlotArea or ProgramText or ListBox)
            && !Layout.IsPart(control)
        && control is not ListBox { ItemCount: 0 };

    // A list and a row of tabs take one Tab; within them the arrows go on.
    private static bool IsThere(Control stop, Control meant) =>
        stop == meant || meant.IsVisualAncestorOf(stop) || stop.IsVisualAncestorOf(meant)
        || (meant is ListBoxItem or TabItem && stop is ListBoxItem or TabItem && stop.Parent == meant.Parent);

    // Up is only gone to the right, into the next column; to the left only downward.
    private bool IsJump(Control from, Control to)
    {
        var (a, b) = (In(from), In(to));
        var shared = Math.Min(a.Bottom, b.Bottom) - Math.Max(a.Top, b.Top);
        return (b.Bottom <= a.Top + Slack && b.Left < a.Right - Slack)
            || (shared > Math.Min(a.Height, b.Height) / 2 && b.Right <= a.Left + Slack);
    }

    private Rect In(Control control) =>
        control.TransformToVisual(seat.Window) is { } matrix ? new Rect(control.Bounds.Size).TransformToAABB(matrix) : default;

    private PixelRect Around(Control control)
    {
        var rect = In(control).Inflate(Slack).Intersect(new Rect(seat.Window.ClientSize));
        return new((int)rect.X, (int)rect.Y, (int)rect.Width, (int)rect.Height);
    }

    private byte[] Pixels(PixelRect rect)
    {
        using var frame = seat.Window.Platform().Frame!.Lock();
        var pixels = new byte[rect.Width * rect.Height * 4];
        for (var y = 0; y < rect.Height; y++)
        {
            System.Runtime.InteropServices.Marshal.Copy(
                frame.Address + ((rect.Y + y) * frame.RowBytes) + (rect.X * 4), pixels, y * rect.Width * 4, rect.Width * 4);
        }

        return pixels;
    }

    private static string Name(Control control) =>
        AutomationProperties.GetAutomationId(control) is { Length: > 0 } id ? id : control.GetType().Name;
}
