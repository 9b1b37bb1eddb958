using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Data;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>The head of a detail view, above its sides. In a low window it scrolls, so that the sides keep room for rows and nothing is
/// drawn over anything else.</summary>
internal sealed class HeadScroll : ScrollViewer
{
    /// <summary>The height that the sides need.</summary>
    public static readonly StyledProperty<double> SidesProperty = AvaloniaProperty.Register<HeadScroll, double>(nameof(Sides));

    // The first lines of a head, and less than this is rounding.
    private const double Fewest = 76, Least = 1;
    private Grid? _whole;

    /// <summary>A head.</summary>
    public HeadScroll()
    {
        HorizontalScrollBarVisibility = ScrollBarVisibility.Disabled;
        this[!AutomationProperties.NameProperty] = (BindingBase)new TextExtension("Head.Name").ProvideValue(null!);
    }

    /// <inheritdoc cref="SidesProperty"/>
    public double Sides
    {
        get => GetValue(SidesProperty);
        set => SetValue(SidesProperty, value);
    }

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(ScrollViewer);

    /// <inheritdoc/>
    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        _whole = this.FindAncestorOfType<Grid>();
        _whole?.SizeChanged += OnWhole;
        Limit();
    }

    /// <inheritdoc/>
    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        _whole?.SizeChanged -= OnWhole;
        base.OnDetachedFromVisualTree(e);
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == SidesProperty)
        {
            Limit();
        }
        else if (change.Property == ExtentProperty || change.Property == ViewportProperty)
        {
            // A tab stop only if there is something to scroll.
            Focusable = Extent.Height >= Viewport.Height + Least;
        }
    }

    private void OnWhole(object? sender, SizeChangedEventArgs e) => Limit();

    private void Limit()
    {
        if (_whole is { Bounds.Height: > 0 and var height })
        {
            MaxHeight = Math.Max(Fewest, height - Sides);
        }
    }
}
