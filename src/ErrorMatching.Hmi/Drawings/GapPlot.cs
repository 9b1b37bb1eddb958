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

    public static readonly StyledProperty<IBrush?> WorstBrushProperty = AvaloniaProperty.Register<GapPlot, IBrush?>(nameof(WorstBrush));

    private PlotBox _extent = PlotBox.Empty;

    static GapPlot() =>
        AffectsRender<GapPlot>(PartBrushProperty, CounterpartBrushProperty, GapBrushProperty, WorstBrushProperty);

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

    /// <summary>Color of the mark at the worst place.</summary>
    public IBrush? WorstBrush
    {
        get => GetValue(WorstBrushProperty);
        set => SetValue(WorstBrushProperty, value);
    }

    /// <inheritdoc/>
    protected override PlotBox Extent => _extent;

    /// <inheritdoc/>
    protected override Thickness Frame =>

        // Names of blocks are wider than those of points.
        Drawing?.Contacts.Count > 0 ? new(DrawnSizes.LegendMark, 0) : default;

    /// <inheritdoc/>
    protected override int DatumCount => Drawing is { } drawing ? drawing.Points.Count + drawing.Contacts.Count + drawing.Seat.Count : 0;

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == DrawingProperty)
        {
            _extent = Drawing?.Extent ?? PlotBox.Empty;
            Renew(Drawing is { } drawing
                ? [.. drawing.Points.Select(p => p.At), .. drawing.Contacts.Select(c => c.At), .. drawing.Seat.Select(s => s.At)]
                : []);
        }
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumAt(int index)
    {
        // First the key points, then the contacts, then the gap along the boundary.
        if (index < 0 || Drawing is not { } drawing)
        {
            return null;
        }

        if (index < drawing.Points.Count)
        {
            var (label, at, _, gap, part, _) = drawing.Points[index];
            return new(
                at,
                Texts.Current.With("Detail.GapAt", label, Shown.SignedMm(-gap, drawing.Interval95Mm(label)), Shown.SignedMm(part)),
                index);
        }

        if (index < drawing.Points.Count + drawing.Contacts.Count)
        {
            var (at, feature, block) = drawing.Contacts[index - drawing.Points.Count];
            return new(at, Texts.Current.With("Detail.ContactAt", feature, block), index);
        }

        var (place, name, mm) = drawing.Seat[index - drawing.Points.Count - drawing.Contacts.Count];
        return new(place, Texts.Current.With("Detail.GapOf", name, Shown.SignedMm(mm)), index);
    }

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

        if (Drawing.Worst is var (worst, said))
        {
            var text = Label(said, isStrong: true);
            if (labels.Place(text, view.At(worst), DrawnSizes.LabelAway, isName: true) is { } room)
            {
                Words(context, text, room);
            }
        }

        foreach (var (at, _, block) in Drawing.Contacts.DistinctBy(c => c.Block))
        {
            var text = Label(block, isStrong: true);
            if (labels.Place(text, view.At(at), DrawnSizes.LabelAway) is { } room)
            {
                Words(context, text, room);
            }
        }

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

        foreach (var (at, _, _) in Drawing.Contacts)
        {
            context.DrawEllipse(null, new Pen(Ink, DrawnSizes.Line), view.At(at), DrawnSizes.Ring, DrawnSizes.Ring);
        }

        if (Drawing.Worst is var (place, _))
        {
            Diamond(context, Ground, new Pen(WorstBrush, DrawnSizes.Line), view.At(place), DrawnSizes.Ring);
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
