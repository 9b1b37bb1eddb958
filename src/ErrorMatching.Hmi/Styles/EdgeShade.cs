using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>The shade at the edge of a scrolled area: it shows that there is more content beyond the last visible row.</summary>
internal sealed class EdgeShade : Control
{
    public static readonly StyledProperty<Vector> OffsetProperty = AvaloniaProperty.Register<EdgeShade, Vector>(nameof(Offset));

    public static readonly StyledProperty<Size> ExtentProperty = AvaloniaProperty.Register<EdgeShade, Size>(nameof(Extent));

    public static readonly StyledProperty<Size> ViewportProperty = AvaloniaProperty.Register<EdgeShade, Size>(nameof(Viewport));

    public static readonly StyledProperty<IBrush?> AboveProperty = AvaloniaProperty.Register<EdgeShade, IBrush?>(nameof(Above));

    public static readonly StyledProperty<IBrush?> BelowProperty = AvaloniaProperty.Register<EdgeShade, IBrush?>(nameof(Below));

    // Less than this is rounding.
    private const int Least = 1;

    static EdgeShade()
    {
        IsHitTestVisibleProperty.OverrideDefaultValue<EdgeShade>(false);
        AffectsRender<EdgeShade>(AboveProperty, BelowProperty);
    }

    public Vector Offset
    {
        get => GetValue(OffsetProperty);
        set => SetValue(OffsetProperty, value);
    }

    /// <summary>Size of the content.</summary>
    public Size Extent
    {
        get => GetValue(ExtentProperty);
        set => SetValue(ExtentProperty, value);
    }

    /// <summary>Size of the visible part.</summary>
    public Size Viewport
    {
        get => GetValue(ViewportProperty);
        set => SetValue(ViewportProperty, value);
    }

    /// <summary>Brush at the upper edge.</summary>
    public IBrush? Above
    {
        get => GetValue(AboveProperty);
        set => SetValue(AboveProperty, value);
    }

    /// <summary>Brush at the lower edge.</summary>
    public IBrush? Below
    {
        get => GetValue(BelowProperty);
        set => SetValue(BelowProperty, value);
    }

    /// <summary>True if there is more content above.</summary>
    public bool IsMoreAbove { get; private set; }

    /// <summary>True if there is more content below.</summary>
    public bool IsMoreBelow { get; private set; }

    /// <inheritdoc/>
    public override void Render(DrawingContext context)
    {
        ArgumentNullException.ThrowIfNull(context);
        if (IsMoreAbove && Above is { } above)
        {
            context.FillRectangle(above, new Rect(0, 0, Bounds.Width, DrawnSizes.EdgeShade));
        }

        if (IsMoreBelow && Below is { } below)
        {
            context.FillRectangle(below, new Rect(0, Bounds.Height - DrawnSizes.EdgeShade, Bounds.Width, DrawnSizes.EdgeShade));
        }
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == OffsetProperty || change.Property == ExtentProperty || change.Property == ViewportProperty)
        {
            var (isAbove, isBelow) = (Offset.Y >= Least, Extent.Height - Offset.Y - Viewport.Height >= Least);
            if ((isAbove, isBelow) != (IsMoreAbove, IsMoreBelow))
            {
                (IsMoreAbove, IsMoreBelow) = (isAbove, isBelow);
                InvalidateVisual();
            }
        }
    }
}
