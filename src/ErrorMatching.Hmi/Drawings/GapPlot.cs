using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Draws the two boundaries of a mating, the same scale in both directions.</summary>
public sealed class GapPlot : Control
{
    /// <summary>What is drawn.</summary>
    public static readonly StyledProperty<GapDrawing?> DrawingProperty = AvaloniaProperty.Register<GapPlot, GapDrawing?>(nameof(Drawing));

    /// <summary>The part's line.</summary>
    public static readonly StyledProperty<IBrush?> PartBrushProperty = AvaloniaProperty.Register<GapPlot, IBrush?>(nameof(PartBrush));

    /// <summary>The counterpart's line.</summary>
    public static readonly StyledProperty<IBrush?> CounterpartBrushProperty = AvaloniaProperty.Register<GapPlot, IBrush?>(nameof(CounterpartBrush));

    /// <summary>The labels.</summary>
    public static readonly StyledProperty<IBrush?> InkProperty = AvaloniaProperty.Register<GapPlot, IBrush?>(nameof(Ink));

    /// <summary>What lies between the two lines.</summary>
    public static readonly StyledProperty<IBrush?> GapBrushProperty = AvaloniaProperty.Register<GapPlot, IBrush?>(nameof(GapBrush));

    private const double Around = 28, Thick = 2, Dot = 3.5, LabelSize = 13, LabelAway = 8;
    private static readonly DashStyle Dashes = new([4, 2], 0);

    static GapPlot() => AffectsRender<GapPlot>(DrawingProperty, PartBrushProperty, CounterpartBrushProperty, GapBrushProperty, InkProperty);

    /// <summary>What is drawn.</summary>
    public GapDrawing? Drawing
    {
        get => GetValue(DrawingProperty);
        set => SetValue(DrawingProperty, value);
    }

    /// <summary>The part's line.</summary>
    public IBrush? PartBrush
    {
        get => GetValue(PartBrushProperty);
        set => SetValue(PartBrushProperty, value);
    }

    /// <summary>The counterpart's line.</summary>
    public IBrush? CounterpartBrush
    {
        get => GetValue(CounterpartBrushProperty);
        set => SetValue(CounterpartBrushProperty, value);
    }

    /// <summary>What lies between the two lines.</summary>
    public IBrush? GapBrush
    {
        get => GetValue(GapBrushProperty);
        set => SetValue(GapBrushProperty, value);
    }

    /// <summary>The labels.</summary>
    public IBrush? Ink
    {
        get => GetValue(InkProperty);
        set => SetValue(InkProperty, value);
    }

    /// <inheritdoc/>
    public override void Render(DrawingContext context)
    {
        ArgumentNullException.ThrowIfNull(context);
        if (Drawing is not { Part.Count: > 0 } drawing || Bounds.Width < 3 * Around || Bounds.Height < 3 * Around)
        {
            return;
        }

        var all = drawing.Part.Concat(drawing.Counterpart).SelectMany(l => l).ToArray();
        var (left, right, low, high) = (all.Min(p => p.X), all.Max(p => p.X), all.Min(p => p.Y), all.Max(p => p.Y));
        var scale = Math.Min((Bounds.Width - (2 * Around)) / Math.Max(right - left, 1e-9), (Bounds.Height - (2 * Around)) / Math.Max(high - low, 1e-9));
        var (x, y) = ((Bounds.Width - (scale * (right - left))) / 2, (Bounds.Height - (scale * (high - low))) / 2);
        Point To(Point2 p) => new(x + (scale * (p.X - left)), y + (scale * (high - p.Y)));

        using var clip = context.PushClip(new Rect(Bounds.Size));
        foreach (var (part, counterpart) in drawing.Part.Zip(drawing.Counterpart))
        {
            context.DrawGeometry(GapBrush, null, Path([.. part, .. counterpart.Reverse()], To, isClosed: true));
        }

        Lines(context, drawing.Counterpart, To, new Pen(CounterpartBrush, Thick, Dashes));
        Lines(context, drawing.Part, To, new Pen(PartBrush, Thick));
        var labels = new List<Rect>();
        foreach (var (label, at) in drawing.Points)
        {
            var place = To(at);
            context.DrawEllipse(PartBrush, null, place, Dot, Dot);
            var text = new FormattedText(label, System.Globalization.CultureInfo.InvariantCulture, FlowDirection.LeftToRight, Typeface.Default, LabelSize, Ink);
            Rect[] sides = [new(place.X + LabelAway, place.Y - (text.Height / 2), text.Width, text.Height), new(place.X - LabelAway - text.Width, place.Y - (text.Height / 2), text.Width, text.Height)];

            // To the right or to the left, where no other label is; a label that finds no room is one that the table has.
            if (sides.FirstOrDefault(s => !labels.Exists(l => l.Intersects(s))) is { Width: > 0 } free)
            {
                labels.Add(free);
                context.DrawText(text, free.TopLeft);
            }
        }
    }

    private static void Lines(DrawingContext context, IReadOnlyList<IReadOnlyList<Point2>> lines, Func<Point2, Point> to, Pen pen)
    {
        foreach (var line in lines)
        {
            context.DrawGeometry(null, pen, Path(line, to, isClosed: false));
        }
    }

    private static StreamGeometry Path(IReadOnlyList<Point2> points, Func<Point2, Point> to, bool isClosed)
    {
        var geometry = new StreamGeometry();
        using var figure = geometry.Open();
        figure.SetFillRule(FillRule.NonZero);
        figure.BeginFigure(to(points[0]), isFilled: isClosed);
        foreach (var point in points.Skip(1))
        {
            figure.LineTo(to(point));
        }

        figure.EndFigure(isClosed);
        return geometry;
    }
}
