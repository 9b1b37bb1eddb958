using Avalonia;
using Avalonia.Automation.Peers;
using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>Draws the error along a section in µm, with the limits as a band, and marks the place of the section.</summary>
internal sealed class MapSectionPlot : PlotPaper, IDrawnWords
{
    public static readonly StyledProperty<SurfaceSections?> SectionsProperty = AvaloniaProperty.Register<MapSectionPlot, SurfaceSections?>(
        nameof(Sections));

    public static readonly StyledProperty<bool> IsAlongVProperty = AvaloniaProperty.Register<MapSectionPlot, bool>(nameof(IsAlongV));

    public static readonly StyledProperty<double> LimitMmProperty = AvaloniaProperty.Register<MapSectionPlot, double>(nameof(LimitMm));

    public static readonly StyledProperty<string?> CaptionProperty = AvaloniaProperty.Register<MapSectionPlot, string?>(nameof(Caption));

    public static readonly StyledProperty<IBrush?> LineBrushProperty = AvaloniaProperty.Register<MapSectionPlot, IBrush?>(
        nameof(LineBrush));

    public static readonly StyledProperty<IBrush?> BandBrushProperty = AvaloniaProperty.Register<MapSectionPlot, IBrush?>(
        nameof(BandBrush));

    static MapSectionPlot()
    {
        AffectsRender<MapSectionPlot>(
            SectionsProperty, IsAlongVProperty, LimitMmProperty, CaptionProperty, LineBrushProperty, BandBrushProperty, BoundsProperty);
        ClipToBoundsProperty.OverrideDefaultValue<MapSectionPlot>(true);
    }

    /// <summary>The sections through a place; null for none.</summary>
    public SurfaceSections? Sections
    {
        get => GetValue(SectionsProperty);
        set => SetValue(SectionsProperty, value);
    }

    /// <summary>True for the section along v.</summary>
    public bool IsAlongV
    {
        get => GetValue(IsAlongVProperty);
        set => SetValue(IsAlongVProperty, value);
    }

    /// <summary>The limits are this far above and below zero; 0 if there are none.</summary>
    public double LimitMm
    {
        get => GetValue(LimitMmProperty);
        set => SetValue(LimitMmProperty, value);
    }

    /// <summary>What is said above the curve.</summary>
    public string? Caption
    {
        get => GetValue(CaptionProperty);
        set => SetValue(CaptionProperty, value);
    }

    /// <summary>Color of the curve.</summary>
    public IBrush? LineBrush
    {
        get => GetValue(LineBrushProperty);
        set => SetValue(LineBrushProperty, value);
    }

    /// <summary>Color of the band between the limits.</summary>
    public IBrush? BandBrush
    {
        get => GetValue(BandBrushProperty);
        set => SetValue(BandBrushProperty, value);
    }

    /// <summary>The shown section.</summary>
    internal MapSection? Section => IsAlongV ? Sections?.AlongV : Sections?.AlongU;

    /// <inheritdoc/>
    IEnumerable<(string Words, Typeface Typeface)> IDrawnWords.DrawnWords => WordsDrawn;

    /// <inheritdoc/>
    public override void Render(DrawingContext context)
    {
        ArgumentNullException.ThrowIfNull(context);
        if (Ground is { } ground)
        {
            context.FillRectangle(ground, new Rect(Bounds.Size));
        }

        Begin();
        if (Sections is not { } sections || Section is not { Points.Count: > 0 } section)
        {
            return;
        }

        // Both sections have one scale, so that they can be compared.
        var limit = SectionPoint.MicrometersPerMm * LimitMm;
        double[] values = [
            0, -limit, limit, .. sections.AlongU.Curve.Concat(sections.AlongV.Curve).Where(p => p.IsFinite).Select(p => p.Y)];
        var (low, high) = (values.Min(), Math.Max(values.Max(), values.Min() + 1e-6));
        var (caption, numbers) = (Label(Caption ?? ""), new[] { high, 0, low }.Select(v => (Value: v, Text: Label(Number(v)))).ToArray());
        var left = numbers.Max(n => n.Text.Width) + (2 * DrawnSizes.Near);
        var inside = new Rect(Bounds.Size).Deflate(
            new Thickness(left, caption.Height + DrawnSizes.Near, DrawnSizes.Around, DrawnSizes.Around));
        context.DrawText(caption, new(left, DrawnSizes.HalfThin));
        if (inside.Width < 1 || inside.Height < 1)
        {
            return;
        }

        var view = ViewOf(inside, section.LengthMm, low, high);
        if (limit > 0 && BandBrush is { } band)
        {
            context.FillRectangle(
                band,
                new Rect(new Point(inside.Left, view.At(new(0, limit)).Y), new Point(inside.Right, view.At(new(0, -limit)).Y)));
        }

        Numbers(context, view, inside, numbers);
        Line(context, new Pen(LineBrush, DrawnSizes.Line), section.Curve, view);
        var at = view.At(new(section.AtMm, SectionPoint.MicrometersPerMm * sections.ValueMm));
        context.DrawLine(new Pen(Rule, DrawnSizes.Thin), new(at.X, inside.Top), new(at.X, inside.Bottom));
        context.DrawEllipse(Ground, new Pen(LineBrush, DrawnSizes.Line), at, DrawnSizes.Dot, DrawnSizes.Dot);
        ShowPixels(context);
    }

    /// <inheritdoc/>
    protected override AutomationPeer OnCreateAutomationPeer() => new DrawnPeer(this, AutomationControlType.Image, () => Caption);

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == CaptionProperty)
        {
            DrawnPeer.Report(this, change.OldValue as string, Caption);
        }
    }

    private PlotView ViewOf(Rect inside, double lengthMm, double low, double high)
    {
        var (scaleX, scaleY) = (inside.Width / Math.Max(lengthMm, 1e-9), inside.Height / (high - low));
        return new(
            scaleX,
            scaleY,
            new(
                (lengthMm / 2) - ((inside.Center.X - (Bounds.Width / 2)) / scaleX),
                ((low + high) / 2) + ((inside.Center.Y - (Bounds.Height / 2)) / scaleY)),
            Bounds.Width,
            Bounds.Height);
    }

    // The ends first; zero only if there is room between them.
    private void Numbers(DrawingContext context, PlotView view, Rect inside, IReadOnlyList<(double Value, FormattedText Text)> numbers)
    {
        var taken = new List<double>();
        foreach (var (value, text) in numbers.OrderBy(n => n.Value == 0))
        {
            var y = view.At(new(0, value)).Y;
            context.DrawLine(
                new Pen(value == 0 ? Ink : Translucent.Of(Rule, DrawnSizes.RuleOpacity), DrawnSizes.Thin),
                new(inside.Left, y),
                new(inside.Right, y));
            if (!taken.Exists(t => Math.Abs(t - y) < text.Height))
            {
                context.DrawText(
                    text,
                    new(
                        inside.Left - text.Width - DrawnSizes.Near,
                        Math.Clamp(y - (text.Height / 2), 0, Math.Max(0, Bounds.Height - text.Height))));
                taken.Add(y);
            }
        }
    }

    private static string Number(double micrometers) => Shown.ShortMicrometers(micrometers / SectionPoint.MicrometersPerMm);
}
