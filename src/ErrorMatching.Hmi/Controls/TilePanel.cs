using Avalonia;
using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Tiles side by side, as many per row as fit. They fill the width equally; tiles in a row have the same height.</summary>
internal sealed class TilePanel : Panel
{
    public static readonly StyledProperty<double> LeastWidthProperty = AvaloniaProperty.Register<TilePanel, double>(nameof(LeastWidth), 1);

    public static readonly StyledProperty<double> SpacingProperty = AvaloniaProperty.Register<TilePanel, double>(nameof(Spacing));

    // A single tile is not stretched to the whole width.
    private const int FewestColumns = 2;

    static TilePanel() => AffectsMeasure<TilePanel>(LeastWidthProperty, SpacingProperty);

    /// <summary>Minimum width of a tile, in device-independent units.</summary>
    public double LeastWidth
    {
        get => GetValue(LeastWidthProperty);
        set => SetValue(LeastWidthProperty, value);
    }

    /// <summary>Gap between two tiles, in device-independent units.</summary>
    public double Spacing
    {
        get => GetValue(SpacingProperty);
        set => SetValue(SpacingProperty, value);
    }

    /// <inheritdoc/>
    protected override Size MeasureOverride(Size availableSize)
    {
        // Without a width limit, all are in one row.
        var width = double.IsFinite(availableSize.Width) ? availableSize.Width : (Children.Count * (LeastWidth + Spacing)) - Spacing;
        var tile = new Size(TileWidth(width), double.PositiveInfinity);
        foreach (var child in Children)
        {
            child.Measure(tile);
        }

        return new(Math.Max(0, width), Math.Max(0, Rows(width).Sum(r => r.Max(t => t.DesiredSize.Height) + Spacing) - Spacing));
    }

    /// <inheritdoc/>
    protected override Size ArrangeOverride(Size finalSize)
    {
        var (each, top) = (TileWidth(finalSize.Width) + Spacing, 0.0);
        foreach (var row in Rows(finalSize.Width))
        {
            var height = row.Max(t => t.DesiredSize.Height);
            for (var column = 0; column < row.Length; column++)
            {
                // Rounded to whole units, so that none is too many at the right.
                var left = Math.Round(column * each);
                row[column].Arrange(new(left, top, Math.Max(0, Math.Round((column + 1) * each) - Spacing - left), height));
            }

            top += height + Spacing;
        }

        return finalSize;
    }

    private int Columns(double width) =>
        Math.Clamp((int)((width + Spacing) / (LeastWidth + Spacing)), 1, Math.Max(FewestColumns, Children.Count));

    private double TileWidth(double width) => Math.Max(0, ((width + Spacing) / Columns(width)) - Spacing);

    private IEnumerable<Control[]> Rows(double width) => Children.Chunk(Columns(width));
}
