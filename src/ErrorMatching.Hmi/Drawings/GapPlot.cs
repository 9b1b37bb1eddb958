using Avalonia;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Draws the two boundaries of a mating, true to scale. Tapping a key point shows its mating error.</summary>
internal sealed class GapPlot : PlotArea
{
    public static readonly StyledProperty<GapDrawing?> DrawingProperty = AvaloniaProperty.Register<GapPlot, GapDrawing?>(nameof(Drawing));

    public static readonly StyledProperty<IBrush?> PartBrushProperty = AvaloniaProperty.Register<GapPlot, IBrush?>(nameof(PartBrush));

    public static readonly StyledProperty<IBrush?> CounterpartBrushProperty = AvaloniaProperty.Register<GapPlot, IBrush?>(
        nameof(CounterpartBrush));

    public static readonly StyledProperty<IBrush?> GapBrushProperty = AvaloniaProperty.Register<GapPlot, IBrush?>(nameof(GapBrush));

    private PlotBox _extent = PlotBox.Empty;

    static GapPlot() => AffectsRender<GapPlot>(PartBrushProperty, CounterpartBrushProperty, GapBrushProperty);

    public GapDrawing? Drawing
    {
        get => GetValue(DrawingProperty);
        set => SetValue(DrawingProperty, value);
    }

    /// <summary>Color of the part's line.</summary>
    public IBrush? PartBrush
    {
        get => GetValue(PartBrushProperty);
        set => SetValue(PartBrushProperty, value);
    }

    /// <summary>Color of the counterpart's line.</summary>
    public IBrush? CounterpartBrush
    {
        get => GetValue(CounterpartBrushProperty);
        set => SetValue(CounterpartBrushProperty, value);
    }

    /// <summary>Color of the area between the two lines.</summary>
    public IBrush? GapBrush
    {
        get => GetValue(GapBrushProperty);
        set => SetValue(GapBrushProperty, value);
    }

    /// <inheritdoc/>
    protected override PlotBox Extent => _extent;

    /// <inheritdoc/>
    protected override int DatumCount => Drawing?.Points.Count ?? 0;

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == DrawingProperty)
        {
            _extent = Drawing?.Extent ?? PlotBox.Empty;
            Renew([.. Drawing?.Points.Select(p => p.At) ?? []]);
        }
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumAt(int index) => index >= 0 && Drawing?.Points[index] is var (label, at, _, gap, part, _)
        ? new(
            at,
            Texts.Current.With("Detail.GapAt", label, Shown.SignedMm(-gap, Drawing.Interval95Mm(label)), Shown.SignedMm(part)),
            index)
        : null;

    /// <inheritdoc/>
    protected override void Draw(DrawingContext context, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        foreach (var (part, counterpart) in Drawing!.Part.Zip(Drawing.Counterpart))
        {
            context.DrawGeometry(GapBrush, null, Area(part.Concat(counterpart.Reverse()), view));
        }

        // A point on a corner is off both lines, and the clearance there may be the largest: the point itself shows it.
        foreach (var (_, at, opposite, _, _, _) in Drawing.Points)
        {
            var (from, to) = (view.At(at), view.At(opposite));
            var way = (Vector)(to - from);
            if (way.Length > DrawnSizes.Dot)
            {
                context.DrawLine(new Pen(GapBrush, DrawnSizes.Thick), from, to);
                var beside = new Vector(-way.Y, way.X) / way.Length * DrawnSizes.Mark;
                context.DrawLine(new Pen(CounterpartBrush, DrawnSizes.Line), to - beside, to + beside);
            }
        }

        foreach (var (line, pen) in Drawing.Counterpart.Select(
            l => (l, new Pen(CounterpartBrush, DrawnSizes.Line, DrawnSizes.Dashes)))
            .Concat(Drawing.Part.Select(l => (l, new Pen(PartBrush, DrawnSizes.Line)))))
        {
            Line(context, pen, line, view);
        }

        var labels = new PlotLabels(
            Drawing.Part.Concat(Drawing.Counterpart).Select(l => (IReadOnlyList<Point>)[.. l.Select(p => view.At(p))]),
            [.. Drawing.Points.Select(p => view.At(p.At))],
            DrawnSizes.Dot,
            Free);

        // Without room for all labels, points outside their limits come first.
        foreach (var (name, at, _, _, _, _) in Drawing.Points.OrderByDescending(p => p.IsOutside))
        {
            var text = Label(name);
            if (labels.Place(text, view.At(at), DrawnSizes.LabelAway) is { } room)
            {
                Words(context, text, room);
            }
        }

        // Drawn last, so that no label's background covers them.
        foreach (var (_, at, _, _, _, _) in Drawing.Points)
        {
            context.DrawEllipse(PartBrush, null, view.At(at), DrawnSizes.Dot, DrawnSizes.Dot);
        }
    }

    /// <inheritdoc/>
    protected override bool IsDrawnIn(PlotBox box) => Drawing!.Part.Concat(Drawing.Counterpart).Any(box.IsCrossedBy);

    private static StreamGeometry Area(IEnumerable<Point2> points, PlotView view)
    {
        var geometry = new StreamGeometry();
        using var figure = geometry.Open();
        figure.SetFillRule(FillRule.NonZero);
        figure.BeginFigure(view.At(points.First()), isFilled: true);
        foreach (var point in points.Skip(1))
        {
            figure.LineTo(view.At(point));
        }

        figure.EndFigure(isClosed: true);
        return geometry;
    }
}
