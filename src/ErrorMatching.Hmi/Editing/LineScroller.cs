using Avalonia;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Shows of one line of text what there is room for, and of a longer one the part that the caret is in.</summary>
// All that a field needs of a scroll viewer, whose parts would take most of the time in which a screen of fields is opened.
public sealed class LineScroller : Decorator
{
    private double _offset;

    /// <summary>A line from its beginning.</summary>
    public LineScroller()
    {
        ClipToBounds = true;
        AddHandler(RequestBringIntoViewEvent, OnWanted);
    }

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
            line.Arrange(new(-_offset, 0, Math.Max(finalSize.Width, line.DesiredSize.Width), finalSize.Height));
        }

        return finalSize;
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
