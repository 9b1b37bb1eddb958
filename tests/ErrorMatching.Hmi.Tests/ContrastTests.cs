using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Documents;
using Avalonia.Controls.Presenters;
using Avalonia.Media;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What is written is read, also if it is disabled, or only says what to type: at least 4.5:1 (WCAG 2.1, 1.4.3).</summary>
[Trait("Length", "Long")]
public sealed class ContrastTests
{
    private const double Least = 4.5;

    [Fact]
    public Task Every_text_of_the_tour_stands_out_from_what_is_behind_it() => Seat.AtAsync(seat =>
    {
        var (faint, seen) = (new SortedSet<string>(StringComparer.Ordinal), 0);
        new Tour(seat).Deliver().Around(stop =>
        {
            foreach (var isDark in new[] { false, true })
            {
                seat.Shell.IsDark = isDark;
                seat.User.Settle();
                foreach (var (text, ink) in Texts(seat))
                {
                    seen++;
                    if (Contrast(text, ink) is < Least and var contrast)
                    {
                        faint.Add($"{contrast:0.00} {(isDark ? "dark" : "light")} {stop}: {Words(text)}");
                    }
                }
            }

            seat.Shell.IsDark = false;
        });
        Assert.True(seen > 2000, $"{seen} texts");
        Assert.True(faint.Count == 0, string.Join('\n', faint));
    });

    private static IEnumerable<(Control Text, IBrush? Ink)> Texts(Seat seat) =>
        from control in seat.Window.GetVisualDescendants().OfType<Control>()
        where control.IsEffectivelyVisible

            // What a dialog stands before is dimmed on purpose.
            && (seat.Shell.IsFree || control.GetVisualAncestors().OfType<Panel>().Any(p => p.Classes.Contains("veil")))
            && !seat.Window.Stage.IsVisualAncestorOf(control) && Words(control) is { Length: > 0 }
        select (control, control is TextBlock block ? block.Foreground : TextElement.GetForeground(control));

    private static string? Words(Control control) => control switch
    {
        TextBlock block => block.Text,
        TextPresenter presenter => presenter.Text,
        _ => null,
    };

    // Null for what is not of one color.
    private static double? Contrast(Control text, IBrush? ink)
    {
        if (ink is not ISolidColorBrush solid)
        {
            return null;
        }

        var opacity = solid.Opacity * text.GetSelfAndVisualAncestors().Aggregate(1.0, (o, v) => o * v.Opacity);
        var ground = Ground(text);
        var color = Over(Color.FromArgb((byte)Math.Round(solid.Color.A * opacity), solid.Color.R, solid.Color.G, solid.Color.B), ground);
        var (a, b) = (Luminance(color), Luminance(ground));
        return (Math.Max(a, b) + 0.05) / (Math.Min(a, b) + 0.05);
    }

    private static Color Ground(Visual text)
    {
        var above = new Stack<Color>();
        foreach (var visual in text.GetVisualAncestors())
        {
            var brush = visual switch
            {
                TextBox box => box.GetVisualDescendants().OfType<Border>().FirstOrDefault(b => b.Name == "PART_BorderElement")?.Background,
                Border border => border.Background,
                Panel panel => panel.Background,
                ContentPresenter presenter => presenter.Background,
                Window window => window.Background,
                _ => null,
            };
            if (brush is ISolidColorBrush { Color.A: > 0 } solid)
            {
                above.Push(Color.FromArgb((byte)Math.Round(solid.Color.A * solid.Opacity), solid.Color.R, solid.Color.G, solid.Color.B));
                if (above.Peek().A == byte.MaxValue)
                {
                    break;
                }
            }
        }

        var ground = above.Pop();
        while (above.TryPop(out var next))
        {
            ground = Over(next, ground);
        }

        return ground;
    }

    private static Color Over(Color top, Color bottom)
    {
        var alpha = top.A / 255.0;
        return Color.FromRgb(Mixed(top.R, bottom.R), Mixed(top.G, bottom.G), Mixed(top.B, bottom.B));

        byte Mixed(byte t, byte b) => (byte)Math.Round((alpha * t) + ((1 - alpha) * b));
    }

    // WCAG 2.1, relative luminance.
    private static double Luminance(Color c) => (0.2126 * Linear(c.R)) + (0.7152 * Linear(c.G)) + (0.0722 * Linear(c.B));

    private static double Linear(byte value) => value / 255.0 is var v && v <= 0.04045 ? v / 12.92 : Math.Pow((v + 0.055) / 1.055, 2.4);
}
