using Avalonia;
using Avalonia.Automation;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.Controls.Primitives;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What is wrong with a layout, measured from it: text that is cut off, things that lie over each other, targets that a gloved
/// finger misses or that a screen reader has no words for.</summary>
internal static class Layout
{
    private const double Slack = 1;
    private const double Target = 57;

    public static IReadOnlyList<string> Problems(Window window)
    {
        var texts = window.GetVisualDescendants()
            .OfType<TextBlock>()
            .Where(t => t.IsEffectivelyVisible && !string.IsNullOrEmpty(t.Text ?? t.Inlines?.Text))
            .ToArray();
        var touched = window.GetVisualDescendants().OfType<Control>().Where(c => c.IsEffectivelyVisible && IsTouched(c)).ToArray();
        return [
            .. texts.SelectMany(t => CutOff(t, window)),
            .. touched.SelectMany(c => TooSmall(c, window)),
            .. Nameless(window),
            .. Overlaps([.. texts, .. touched.Where(c => !IsPart(c))], window),
            .. Hidden.Problems(window)];
    }

    public static bool IsTouched(Control control) =>
        control is Button or TextBox or ComboBox or TabItem
            || (control is ListBoxItem item && item.FindAncestorOfType<ListBox>() is { } list && !list.Classes.Contains("figures"));

    private static IEnumerable<string> CutOff(TextBlock text, Window window)
    {
        var (layout, room) = (text.TextLayout, text.Bounds.Deflate(text.Padding));
        if (layout.TextLines.Any(l => l.HasCollapsed))
        {
            yield return $"\"{Words(text)}\" is trimmed";
        }

        if (layout.Width > room.Width + Slack || layout.Height > room.Height + Slack)
        {
            yield return $"\"{Words(text)}\" needs {layout.Width:0} x {layout.Height:0} and has {room.Width:0} x {room.Height:0}";
        }

        // What can be scrolled to is not cut off; everything else has to lie inside of what clips it.
        var place = In(text, window);
        foreach (var above in text.GetVisualAncestors().OfType<Control>().TakeWhile(a => a is not ScrollContentPresenter))
        {
            if ((above.ClipToBounds || above == window) && !In(above, window).Inflate(Slack).Contains(place))
            {
                yield return $"\"{Words(text)}\" leaves {above.GetType().Name}";
            }
        }

        if (text.FindAncestorOfType<ScrollContentPresenter>() is { } scrolled
            && (place.Left < In(scrolled, window).Left - Slack || place.Right > In(scrolled, window).Right + Slack))
        {
            yield return $"\"{Words(text)}\" is cut off at the side";
        }
    }

    private static IEnumerable<string> TooSmall(Control control, Window window)
    {
        // The buttons inside of a field or of a scroll bar are not what is tapped.
        if (control.FindAncestorOfType<TextBox>() is not null || control.FindAncestorOfType<ScrollBar>() is not null)
        {
            yield break;
        }

        var size = In(control, window).Size;
        if (size.Height < Target - 0.5 || size.Width < Target - 0.5)
        {
            yield return $"{control.GetType().Name} {AutomationProperties.GetAutomationId(control)} is {size.Width:0} x {size.Height:0}";
        }
    }

    // What a screen reader says of what is touched, and of each row; a name of a type is none.
    private static IEnumerable<string> Nameless(Window window)
    {
        foreach (var control in window.GetVisualDescendants()
            .OfType<Control>()
            .Where(
                c => c.IsEffectivelyVisible && (IsTouched(c) || c is ListBoxItem or PlotArea or ProgramText or ColorLegend) && !IsPart(c)))
        {
            var peer = ControlAutomationPeer.CreatePeerForElement(control);
            if (peer.GetName() is not { } name
                || string.IsNullOrWhiteSpace(name)
                || name.Contains("Avalonia.", StringComparison.Ordinal)
                || name.Contains(" { ", StringComparison.Ordinal)
                || name.StartsWith("ErrorMatching.", StringComparison.Ordinal))
            {
                yield return $"{control.GetType().Name} {AutomationProperties.GetAutomationId(control)} is called \"{peer.GetName()}\"";
            }

            if (peer.GetAutomationControlType() is AutomationControlType.None or AutomationControlType.Custom)
            {
                yield return $"{control.GetType().Name} {AutomationProperties.GetAutomationId(control)} has no role";
            }
        }
    }

    // The buttons inside of a field or of a scroll bar.
    public static bool IsPart(Control control) =>
        control.FindAncestorOfType<TextBox>() is not null
            || control.FindAncestorOfType<ScrollBar>() is not null
            || control.FindAncestorOfType<ComboBox>() is not null;

    private static IEnumerable<string> Overlaps(IReadOnlyList<Control> controls, Window window)
    {
        var seen = controls.Select(c => (Control: c, Place: Seen(c, window))).Where(c => c.Place.Width > 0 && c.Place.Height > 0).ToArray();
        for (var i = 0; i < seen.Length; i++)
        {
            for (var j = i + 1; j < seen.Length; j++)
            {
                var shared = seen[i].Place.Intersect(seen[j].Place);
                if (shared.Width > Slack && shared.Height > Slack && IsInFront(seen[i].Control) == IsInFront(seen[j].Control)
                    && !seen[i].Control.IsVisualAncestorOf(seen[j].Control) && !seen[j].Control.IsVisualAncestorOf(seen[i].Control))
                {
                    yield return $"{Name(seen[i].Control)} and {Name(seen[j].Control)} lie over each other";
                }
            }
        }
    }

    // A dialog lies over everything, on purpose.
    private static bool IsInFront(Control control) => control.GetVisualAncestors().OfType<Panel>().Any(p => p.Classes.Contains("veil"));

    public static Rect Seen(Control control, Window window) =>
        control.GetVisualAncestors()
            .OfType<Control>()
            .Where(a => a.ClipToBounds || a is ScrollContentPresenter)
            .Aggregate(In(control, window), (place, above) => place.Intersect(In(above, window)));

    public static Rect In(Visual visual, Window window) =>
        new Rect(visual.Bounds.Size).TransformToAABB(visual.TransformToVisual(window) ?? Matrix.Identity);

    public static string Name(Control control) =>
        control is TextBlock text ? $"\"{Words(text)}\"" : $"{control.GetType().Name} {Id(control)}";

    // Parts of a template have no name of their own.
    private static string? Id(Control control) => control.GetSelfAndVisualAncestors()
        .OfType<Control>()
        .Select(AutomationProperties.GetAutomationId)
        .FirstOrDefault(id => !string.IsNullOrEmpty(id));

    private static string? Words(TextBlock text) => text.Text ?? text.Inlines?.Text;
}
