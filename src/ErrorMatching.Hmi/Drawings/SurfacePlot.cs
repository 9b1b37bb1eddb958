using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Immutable;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Draws a surface from above, colors by value or the way of the stylus over it; under the finger the values of a point.</summary>
public sealed class SurfacePlot : PlotArea
{
    /// <summary>What is drawn.</summary>
    public static readonly StyledProperty<SurfaceDrawing?> DrawingProperty = AvaloniaProperty.Register<SurfacePlot, SurfaceDrawing?>(nameof(Drawing));

    /// <summary>The surface where it has no values.</summary>
    public static readonly StyledProperty<IBrush?> AreaBrushProperty = AvaloniaProperty.Register<SurfacePlot, IBrush?>(nameof(AreaBrush));

    /// <summary>The way of the stylus.</summary>
    public static readonly StyledProperty<IBrush?> WayBrushProperty = AvaloniaProperty.Register<SurfacePlot, IBrush?>(nameof(WayBrush));

    /// <summary>What is written on a map, whose colors are the same in every theme.</summary>
    public static readonly StyledProperty<IBrush?> MapInkProperty = AvaloniaProperty.Register<SurfacePlot, IBrush?>(nameof(MapInk));

    /// <summary>What lies behind that: the color of zero.</summary>
    public static readonly StyledProperty<IBrush?> MapPaperProperty = AvaloniaProperty.Register<SurfacePlot, IBrush?>(nameof(MapPaper));

    // Each cell of the net is drawn in so many by so many: colors change little from one to the next.
    private const int Parts = 3;

    // Of the distance between two points: the surface is to be seen between their dots.
    private const double DotShare = 0.15;
    private PlotBox _extent = PlotBox.Empty;
    private IReadOnlyList<(int Color, StreamGeometry Geometry)> _cells = [];
    private double _nearest = double.PositiveInfinity;

    static SurfacePlot() => AffectsRender<SurfacePlot>(AreaBrushProperty, WayBrushProperty, MapInkProperty, MapPaperProperty);

    /// <summary>What is drawn.</summary>
    public SurfaceDrawing? Drawing
    {
        get => GetValue(DrawingProperty);
        set => SetValue(DrawingProperty, value);
    }

    /// <summary>The surface where it has no values.</summary>
    public IBrush? AreaBrush
    {
        get => GetValue(AreaBrushProperty);
        set => SetValue(AreaBrushProperty, value);
    }

    /// <summary>The way of the stylus.</summary>
    public IBrush? WayBrush
    {
        get => GetValue(WayBrushProperty);
        set => SetValue(WayBrushProperty, value);
    }

    /// <summary>What is written on a map, whose colors are the same in every theme.</summary>
    public IBrush? MapInk
    {
        get => GetValue(MapInkProperty);
        set => SetValue(MapInkProperty, value);
    }

    /// <summary>What lies behind that: the color of zero.</summary>
    public IBrush? MapPaper
    {
        get => GetValue(MapPaperProperty);
        set => SetValue(MapPaperProperty, value);
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
            _cells = Drawing is null ? [] : CellsOf(Drawing);
            _nearest = Drawing?.NearestDistance() ?? double.PositiveInfinity;
            Renew([.. Drawing?.Points.Select(p => p.At) ?? []]);
        }
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumAt(int index) => index >= 0 && Drawing is { } drawing ? new(drawing.Points[index].At, drawing.Points[index].Values, index) : null;

    /// <inheritdoc/>
    protected override void Draw(DrawingContext context, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        var drawing = Drawing!;
        var origin = To(view, Point2.Origin);
        using (context.PushTransform(new Matrix(view.ScaleX, 0, 0, -view.ScaleY, origin.X, origin.Y)))
        {
            foreach (var (color, geometry) in _cells)
            {
                // The stroke closes the hairlines between neighbors.
                var brush = color < 0 ? AreaBrush : MapColors.Scale[color];
                context.DrawGeometry(brush, new Pen(brush, DrawnSizes.Hairline / view.ScaleX), geometry);
            }
        }

        Way(context, view, drawing);
        Dots(context, view, drawing);
    }

    /// <summary>How large a point's dot is, in units of the screen: small where the points lie close together, so that a small map does not disappear behind them.</summary>
    internal double DotRadius(PlotView view) => Math.Clamp(DotShare * _nearest * view.ScaleX, DrawnSizes.LeastDot, DrawnSizes.Dot);

    private static Point To(PlotView view, Point2 place)
    {
        var (x, y) = view.ToScreen(place);
        return new(x, y);
    }

    // Made once, in the plot's units, one geometry a color: whoever moves the map or goes nearer draws the same again.
    private static List<(int Color, StreamGeometry Geometry)> CellsOf(SurfaceDrawing drawing)
    {
        var geometries = new List<(int Color, StreamGeometry Geometry)>();
        foreach (var color in Quadrangles(drawing).GroupBy(q => q.Color))
        {
            var geometry = new StreamGeometry();
            using (var figures = geometry.Open())
            {
                figures.SetFillRule(FillRule.NonZero);
                foreach (var (_, corners) in color)
                {
                    Quadrangle(figures, corners);
                }
            }

            geometries.Add((color.Key, geometry));
        }

        return geometries;
    }

    private static IEnumerable<(int Color, Point[] Corners)> Quadrangles(SurfaceDrawing drawing)
    {
        const double SideShare = 1.0 / Parts;
        var (net, outside) = (drawing.Net, drawing.Net.Outside.ToHashSet());
        Point[] places = [.. net.Places.Select(p => new Point(p.X, p.Y))];
        for (var cell = 0; cell < (net.CountU - 1) * (net.CountV - 1); cell++)
        {
            if (outside.Contains(cell))
            {
                continue;
            }

            var a = (cell / (net.CountV - 1) * net.CountV) + (cell % (net.CountV - 1));
            int[] corners = [a, a + net.CountV, a + net.CountV + 1, a + 1];
            if (drawing.ValuesMm is not { } values)
            {
                yield return (-1, [.. corners.Select(c => places[c])]);
                continue;
            }

            for (var part = 0; part < Parts * Parts; part++)
            {
                var (s, t) = ((double)(part / Parts) / Parts, (double)(part % Parts) / Parts);
                Point At(double u, double v) => Between(corners, c => places[c], u, v);
                var value = Between(corners, c => new Point(values[c], 0), s + (SideShare / 2), t + (SideShare / 2)).X;
                yield return (DivergingColors.IndexOf(value, drawing.LimitMm), [At(s, t), At(s + SideShare, t), At(s + SideShare, t + SideShare), At(s, t + SideShare)]);
            }
        }
    }

    private static Point Between(int[] corners, Func<int, Point> at, double s, double t) =>
        (at(corners[0]) * ((1 - s) * (1 - t))) + (at(corners[1]) * (s * (1 - t))) + (at(corners[2]) * (s * t)) + (at(corners[3]) * ((1 - s) * t));

    private static void Quadrangle(StreamGeometryContext figures, Point[] corners)
    {
        figures.BeginFigure(corners[0], isFilled: true);
        figures.LineTo(corners[1]);
        figures.LineTo(corners[2]);
        figures.LineTo(corners[3]);
        figures.EndFigure(isClosed: true);
    }

    private void Way(DrawingContext context, PlotView view, SurfaceDrawing drawing)
    {
        if (!drawing.ShowsWay)
        {
            return;
        }

        var pen = new Pen(WayBrush, DrawnSizes.Line);
        for (var i = 1; i < drawing.Points.Count; i++)
        {
            context.DrawLine(pen, To(view, drawing.Points[i - 1].At), To(view, drawing.Points[i].At));
        }

        if (drawing.Points.Count > 0)
        {
            var first = DrawnSizes.Ring / DrawnSizes.Dot * DotRadius(view);
            context.DrawEllipse(Ground, pen, To(view, drawing.Points[0].At), first, first);
        }
    }

    private void Dots(DrawingContext context, PlotView view, SurfaceDrawing drawing)
    {
        // Colors of the map are the same in both themes, and so is what is written on them.
        var isMap = drawing.ValuesMm is not null;
        var ink = isMap ? MapInk : Ink;
        var radius = DotRadius(view);
        var labels = new List<(FormattedText Text, Rect Room)>();
        foreach (var (label, at, _) in drawing.Points)
        {
            var place = To(view, at);
            context.DrawEllipse(isMap ? ink : WayBrush, null, place, radius, radius);
            var text = Label(label);
            if (ink is not null)
            {
                text.SetForegroundBrush(ink);
            }

            labels.Add((text, new Rect(place.X - (text.Width / 2), place.Y - text.Height - DrawnSizes.NumberAbove, text.Width, text.Height).Inflate(new Thickness(DrawnSizes.VeilBeside, 0))));
        }

        // All or none: labels that find no room appear when one goes nearer. A brush that shows through is drawn at once; a group that does takes a picture of its own for each label.
        var veil = (isMap ? MapPaper : Ground) is ISolidColorBrush paper ? new ImmutableSolidColorBrush(paper.Color, isMap ? DrawnSizes.MapVeilOpacity : DrawnSizes.VeilOpacity) : null;
        if (HaveRoom(labels, new Rect(Bounds.Size)))
        {
            foreach (var (text, room) in labels)
            {
                // What lies behind shows through; on a line it would cross the number.
                if (veil is not null)
                {
                    context.FillRectangle(veil, room, (float)DrawnSizes.VeilRound);
                }

                context.DrawText(text, new(room.X + DrawnSizes.VeilBeside, room.Y));
            }
        }
    }

    private static bool HaveRoom(List<(FormattedText Text, Rect Room)> labels, Rect seen)
    {
        var rooms = labels.Select(l => l.Room).Where(r => r.Intersects(seen)).OrderBy(r => r.Left).ToArray();
        for (var i = 0; i < rooms.Length; i++)
        {
            for (var j = i + 1; j < rooms.Length && rooms[j].Left < rooms[i].Right; j++)
            {
                if (rooms[i].Intersects(rooms[j]))
                {
                    return false;
                }
            }
        }

        return true;
    }
}
