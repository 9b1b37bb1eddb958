using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Documents;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>Shows of one line of text what there is room for, and of a longer one the part that the caret is in.</summary>
// All that a field needs of a scroll viewer, whose parts would take most of the time in which a screen of fields is opened.
public sealed class LineScroller : Decorator
{
    /// <summary>What a number lacks that others under it or above have behind their decimal signs, such as <c>.000</c>: so much room is
    /// left at the right, and the signs stand under each other. What is typed is not touched.</summary>
    public static readonly AttachedProperty<string?> MissingProperty = AvaloniaProperty.RegisterAttached<LineScroller, Control, string?>(
        "Missing", inherits: true);

    private double _offset;

    static LineScroller() => AffectsArrange<LineScroller>(MissingProperty);

    /// <summary>A line from its beginning.</summary>
    public LineScroller()
    {
        ClipToBounds = true;
        AddHandler(RequestBringIntoViewEvent, OnWanted);
    }

    // Digits of one width, as the field has them.
    private double Room => GetMissing(this) is { Length: > 0 } missing ? WidthOf(missing) : 0;

    /// <summary>What the number in a field lacks.</summary>
    public static string? GetMissing(Control field) => (field ?? throw new ArgumentNullException(nameof(field))).GetValue(MissingProperty);

    /// <summary>Leaves room in a field for what its number lacks.</summary>
    public static void SetMissing(Control field, string? digits) =>
        (field ?? throw new ArgumentNullException(nameof(field))).SetValue(MissingProperty, digits);

    /// <inheritdoc/>
    protected override Size MeasureOverride(Size availableSize)
    {
        Child?.Measure(availableSize.WithWidth(double.PositiveInfinity));
        return Child?.DesiredSize.Constrain(availableSize) ?? default;
    }

    /// <inheritdoc/>
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

    // Not handled: what is around the field brings the field into view.
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
