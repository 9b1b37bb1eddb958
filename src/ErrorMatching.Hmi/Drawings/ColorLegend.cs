using System.Globalization;
using Avalonia;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.Media;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Color scale of a map: a bar from the lowest value to the highest with zero in the middle, with signs and unit.</summary>
internal sealed class ColorLegend : Control, IDrawnWords
{
    public static readonly StyledProperty<double> LimitMmProperty = AvaloniaProperty.Register<ColorLegend, double>(nameof(LimitMm));

    public static readonly StyledProperty<IBrush?> InkProperty = AvaloniaProperty.Register<ColorLegend, IBrush?>(nameof(Ink));

    public static readonly StyledProperty<double> LabelSizeProperty = AvaloniaProperty.Register<ColorLegend, double>(nameof(LabelSize), 1);

    private static readonly double[] Ticks = [-1, -0.5, 0, 0.5, 1];

    static ColorLegend()
    {
        AffectsRender<ColorLegend>(LimitMmProperty, InkProperty, LabelSizeProperty);
        AffectsMeasure<ColorLegend>(LabelSizeProperty);
    }

    /// <summary>The absolute value of the last colors, in mm.</summary>
    public double LimitMm
    {
        get => GetValue(LimitMmProperty);
        set => SetValue(LimitMmProperty, value);
    }

    /// <summary>Color of the numbers.</summary>
    public IBrush? Ink
    {
        get => GetValue(InkProperty);
        set => SetValue(InkProperty, value);
    }

    public double LabelSize
    {
        get => GetValue(LabelSizeProperty);
        set => SetValue(LabelSizeProperty, value);
    }

    /// <inheritdoc/>
    IEnumerable<(string Words, Typeface Typeface)> IDrawnWords.DrawnWords => Ticks.Select(t => (Words(t), Typeface.Default));

    /// <inheritdoc/>
    public override void Render(DrawingContext context)
    {
        ArgumentNullException.ThrowIfNull(context);
        var ends = Text(-1);
        var (left, width) = (ends.Width / 2, Bounds.Width - ends.Width);
        if (width <= 0)
        {
            return;
        }

        for (var i = 0; i < DivergingColors.Count; i++)
        {
            context.FillRectangle(
                MapColors.Scale[i],
                new Rect(
                    left + (width * i / DivergingColors.Count),
                    0,
                    (width / DivergingColors.Count) + DrawnSizes.Overlap,
                    DrawnSizes.ColorBar));
        }

        // The color for zero is the background's, so the bar needs a frame.
        context.DrawRectangle(
            null,
            new Pen(Translucent.Of(Ink, DrawnSizes.FrameOpacity)),
            new Rect(left, DrawnSizes.HalfThin, width, DrawnSizes.ColorBar - DrawnSizes.HalfThin));

        // Where five numbers would touch one another, there are three.
        var few = Ticks.Sum(t => Text(t).Width + DrawnSizes.LabelsApart) > Bounds.Width;
        foreach (var tick in Ticks.Where(t => !few || Math.Abs(t) is 0 or 1))
        {
            // The first and the last color reach half a step beyond their values.
            var x = left + (width * (0.5 + (tick * (DivergingColors.Count - 1) / DivergingColors.Count / 2)));
            var text = Text(tick);
            context.DrawLine(new Pen(Ink), new(x, DrawnSizes.ColorBar), new(x, DrawnSizes.ColorBar + DrawnSizes.Tick));
            context.DrawText(
                text, new(Math.Clamp(x - (text.Width / 2), 0, Bounds.Width - text.Width), DrawnSizes.ColorBar + DrawnSizes.Tick));
        }
    }

    /// <inheritdoc/>
    protected override AutomationPeer OnCreateAutomationPeer() =>
        new DrawnPeer(this, AutomationControlType.Image, () => $"{Words(-1)}, {Words(1)}");

    /// <inheritdoc/>
    protected override Size MeasureOverride(Size availableSize) => new(0, DrawnSizes.ColorBar + DrawnSizes.Tick + Text(1).Height);

    private string Words(double share) =>
        (1000 * LimitMm * share).ToString("+0.#;−0.#;0", CultureInfo.InvariantCulture) + (share == 0 ? "" : " µm");

    private FormattedText Text(double share) => new(
        Words(share), CultureInfo.InvariantCulture, FlowDirection.LeftToRight, Typeface.Default, LabelSize, Ink);
}
