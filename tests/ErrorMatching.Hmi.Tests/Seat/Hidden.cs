using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What is on a screen, and is not seen whole by whoever looks at it.</summary>
internal static class Hidden
{
    private const double Slack = 1;

    /// <summary>All of it.</summary>
    public static IEnumerable<string> Problems(Window window) =>
        [.. MissingGlyphs(window), .. Clipped(window), .. Slits(window), .. LowFields(window), .. CutLines(window)];

    // Characters that the font, and whatever takes its place, has no picture for: a box is drawn instead.
    private static IEnumerable<string> MissingGlyphs(Window window) =>
        window.GetVisualDescendants().OfType<Control>().Where(c => c.IsEffectivelyVisible && LayoutsOf(c).Any(IsMissing))
        .Select(c => $"{Layout.Name(c)} has a character without a glyph");

    private static IEnumerable<TextLayout> LayoutsOf(Control control) => control switch
    {
        TextBlock text => [text.TextLayout],
        TextPresenter typed => [typed.TextLayout],
        IDrawnWords drawn =>
            drawn.DrawnWords.SelectMany(d => d.Words.Split('\n').Select(l => new TextLayout(l, d.Typeface, 14, Brushes.Black))),
        _ => [],
    };

    private static bool IsMissing(TextLayout layout) =>
        layout.TextLines.SelectMany(l => l.TextRuns).OfType<ShapedTextRun>().Any(r => r.ShapedBuffer.Any(g => g.GlyphIndex == 0));

    // What is touched, drawn or scrolled in, and is partly behind the border of something that clips it and does not scroll to it.
    private static IEnumerable<string> Clipped(Window window)
    {
        foreach (var control in window.GetVisualDescendants()
            .OfType<Control>()
            .Where(
                c => c.IsEffectivelyVisible
                    && (Layout.IsTouched(c) || c is PlotArea or ColorLegend or ScrollContentPresenter)
                    && !Layout.IsPart(c)))
        {
            var place = Layout.In(control, window);
            if (control.GetVisualAncestors().OfType<Control>().TakeWhile(a => a is not ScrollContentPresenter)
                .FirstOrDefault(a => (a.ClipToBounds || a == window) && !Layout.In(a, window).Inflate(Slack).Contains(place)) is { } above)
            {
                yield return $"{Layout.Name(control)} is clipped by {above.GetType().Name}";
            }

            if (control.FindAncestorOfType<ScrollContentPresenter>() is { CanHorizontallyScroll: false } scrolled
                && Layout.In(scrolled, window).Inflate(Slack) is var seen
                && (place.Left < seen.Left || place.Right > seen.Right))
            {
                yield return $"{Layout.Name(control)} is clipped at the side";
            }
        }
    }

    // What can be scrolled to and is never seen whole, because what it is seen through is lower.
    private static IEnumerable<string> Slits(Window window) =>
        from control in window.GetVisualDescendants().OfType<Control>()
        where control.IsEffectivelyVisible && Layout.IsTouched(control) && !Layout.IsPart(control)
        let seen = control.FindAncestorOfType<ScrollContentPresenter>()?.Bounds.Height
        where seen < Math.Min(control.Bounds.Height, control.MinHeight) - Slack
        select $"{Layout.Name(control)} is scrolled to, {control.Bounds.Height:0} high, through {seen:0}";

    // Fields whose line, typed or asked for, is higher than what is seen of it.
    private static IEnumerable<string> LowFields(Window window)
    {
        foreach (var field in window.GetVisualDescendants().OfType<TextBox>().Where(f => f.IsEffectivelyVisible && !f.AcceptsReturn))
        {
            foreach (var line in field.GetVisualDescendants()
                .OfType<Control>()
                .Where(c => c.IsEffectivelyVisible && c is TextPresenter { Text.Length: > 0 } or TextBlock { Text.Length: > 0 }))
            {
                var height = (line as TextPresenter)?.TextLayout.Height ?? ((TextBlock)line).TextLayout.Height;
                var seen = line.GetVisualAncestors()
                    .OfType<Control>()
                    .TakeWhile(a => a != field.GetVisualParent())
                    .Where(a => a.ClipToBounds || a == field || a is ScrollContentPresenter)
                    .Aggregate(Layout.In(line, window), (place, above) => place.Intersect(Layout.In(above, window)));
                if (seen.Height < height - Slack)
                {
                    yield return $"{Layout.Name(field)} shows {seen.Height:0} of a line of {height:0}";
                }
            }
        }
    }

    // Lines of a program that go on where nobody sees it, without an ellipsis that says so.
    private static IEnumerable<string> CutLines(Window window) =>
        from text in window.GetVisualDescendants().OfType<ProgramText>()
        where text.IsEffectivelyVisible
        let seen = Layout.Seen(text, window).Right - Layout.In(text, window).Left
        from row in text.RowsEnd
        where row.End > seen + Slack
        select $"line {row.Block + 1} of {Layout.Name(text)} ends at {row.End:0} of {seen:0}";
}
