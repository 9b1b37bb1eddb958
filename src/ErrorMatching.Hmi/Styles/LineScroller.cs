using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Documents;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>Shows one line of text; if it does not fit, the part with the caret.</summary>
// The few functions of a scroll viewer that a field needs. A full one would take most of the time to open a screen of fields.
internal sealed class LineScroller : Decorator
{
    /// <summary>The decimals that a number lacks compared with others in its column, such as <c>.000</c>. Space for them is left at the
    /// right, so that decimal signs align. The typed text does not change.</summary>
    public static readonly AttachedProperty<string?> MissingProperty = AvaloniaProperty.RegisterAttached<LineScroller, Control, string?>(
        "Missing", inherits: true);

    private double _offset;

    static LineScroller() => AffectsArrange<LineScroller>(MissingProperty);

    public LineScroller()
    {
        ClipToBounds = true;
        AddHandler(RequestBringIntoViewEvent, OnWanted);
    }

    // Width with the field's tabular digits.
    private double Room => GetMissing(this) is { Length: > 0 } missing ? WidthOf(missing) : 0;

    public static string? GetMissing(Control field) => (field ?? throw new ArgumentNullException(nameof(field))).GetValue(MissingProperty);

    /// <summary>Leaves space in a field for the missing decimals.</summary>
    public static void SetMissing(Control field, string? digits) =>
        (field ?? throw new ArgumentNullException(nameof(field))).SetValue(MissingProperty, digits);

    protected override Size MeasureOverride(Size availableSize)
    {
        Child?.Measure(availableSize.WithWidth(double.PositiveInfinity));
        return Child?.DesiredSize.Constrain(availableSize) ?? default;
    }

    protected override Size ArrangeOverride(Size finalSize)
    {
        if (Child is { } line)
        {
            _offset = Math.Clamp(_offset, 0, Math.Max(0, line.DesiredSize.Width - finalSize.Width));
            line.Arrange(new(-_offset, 0, Math.Max(finalSize.Width - Room, line.DesiredSize.Width), finalSize.Height));
        }

        return finalSize;
    }

    private double WidthOf(string text)
    {
        var shown = new FormattedText(
            text,
            CultureInfo.InvariantCulture,
            FlowDirection.LeftToRight,
            new Typeface(TextElement.GetFontFamily(this)),
            TextElement.GetFontSize(this),
            null);
        shown.SetFontFeatures(TextElement.GetFontFeatures(this));
        return shown.Width;
    }

    // Not handled, so that the surrounding controls bring the field into view.
    private void OnWanted(object? sender, RequestBringIntoViewEventArgs e)
    {
        if (e.TargetObject is { } target && target != this && target.TransformToVisual(this) is { } toHere)
        {
            var wanted = e.TargetRect.TransformToAABB(toHere);
            var moved = wanted.Right > Bounds.Width ? wanted.Right - Bounds.Width : wanted.Left < 0 ? wanted.Left : 0;
            if (moved != 0)
            {
                _offset += moved;
                InvalidateArrange();
            }
        }
    }
}
