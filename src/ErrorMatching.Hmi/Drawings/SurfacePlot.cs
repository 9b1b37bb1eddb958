using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Immutable;
using ErrorMatching.Geometry;

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

    // Of the distance between two points: the surface is to be seen between their dots.
    private const double DotShare = 0.15;
    private PlotBox _extent = PlotBox.Empty;
    private List<(int Color, StreamGeometry Geometry)>? _shapes;
    private StreamGeometry? _border;
    private List<FormattedText>? _texts;
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

    /// <summary>True once it was seen: shapes are made when they are drawn first, for of the maps of a screen most are on sides that nobody looks at.</summary>
    internal bool HasShapes => _shapes is not null;

    /// <summary>True if each point has its number, here and in the twin.</summary>
    internal bool ShowsNumbers => HasRoom && (Twin is not SurfacePlot twin || twin.HasRoom);

    private bool HasRoom => Drawing is null || HaveRoom(Labels(), new Rect(Bounds.Size));

    /// <inheritdoc/>
    protected override PlotBox Extent => _extent;

    /// <inheritdoc/>
    protected override IEnumerable<string> KeptWords => Drawing?.Points.Select(p => p.Label) ?? [];

    /// <inheritdoc/>
    protected override int DatumCount => Drawing?.Points.Count ?? 0;

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == DrawingProperty || change.Property == InkProperty || change.Property == MapInkProperty || change.Property == LabelSizeProperty)
        {
            _texts = null;
        }

        if (change.Property == DrawingProperty)
        {
            _extent = Drawing?.Extent ?? PlotBox.Empty;
            (_shapes, _border) = (null, null);
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
            foreach (var (color, geometry) in _shapes ??= ShapesOf(drawing.Cells))
            {
                // The stroke closes the hairlines between neighbors.
                var brush = color < 0 ? AreaBrush : MapColors.Scale[color];
                context.DrawGeometry(brush, new Pen(brush, DrawnSizes.Hairline / view.ScaleX), geometry);
            }

            // The color of zero is that of paper.
            context.DrawGeometry(null, new Pen(Rule, DrawnSizes.Thin / view.ScaleX), _border ??= BorderOf(drawing.Cells));
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

    // In the plot's units, one geometry a color: whoever moves the map or goes nearer draws the same again.
    private static List<(int Color, StreamGeometry Geometry)> ShapesOf(SurfaceCells cells)
    {
        var shapes = new List<(int Color, StreamGeometry Geometry)>();
        foreach (var color in cells.Pieces.GroupBy(q => q.Color))
        {
            var geometry = new StreamGeometry();
            using (var figures = geometry.Open())
            {
                figures.SetFillRule(FillRule.NonZero);
                foreach (var (_, corners) in color)
                {
                    Figure(figures, corners, isClosed: true);
                }
            }

            shapes.Add((color.Key, geometry));
        }

        return shapes;
    }

    private static StreamGeometry BorderOf(SurfaceCells cells)
    {
        var geometry = new StreamGeometry();
        using var figures = geometry.Open();
        foreach (var (from, to) in cells.Border)
        {
            Figure(figures, [from, to], isClosed: false);
        }

        return geometry;
    }

    private static void Figure(StreamGeometryContext figures, IReadOnlyList<Point2> corners, bool isClosed)
    {
        figures.BeginFigure(new(corners[0].X, corners[0].Y), isFilled: isClosed);
        for (var i = 1; i < corners.Count; i++)
        {
            figures.LineTo(new(corners[i].X, corners[i].Y));
        }

        figures.EndFigure(isClosed);
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
        var radius = DotRadius(view);

        // With a ring of paper: in the dark, those on the border would lose their outer half.
        var ring = isMap && radius > DrawnSizes.MeanMark ? new Pen(MapPaper, DrawnSizes.Thin) : null;
        foreach (var (_, at, _) in drawing.Points)
        {
            context.DrawEllipse(isMap ? MapInk : WayBrush, ring, To(view, at), radius, radius);
        }

        // All or none, here and in the twin beside it: labels that find no room appear when one goes nearer. A brush that shows through is drawn at once; a group that does takes a picture of its own for each label.
        if (!ShowsNumbers)
        {
            return;
        }

        var veil = (isMap ? MapPaper : Ground) is ISolidColorBrush paper ? new ImmutableSolidColorBrush(paper.Color, isMap ? DrawnSizes.MapVeilOpacity : DrawnSizes.VeilOpacity) : null;
        foreach (var (text, room) in Labels())
        {
            // What lies behind shows through; on a line it would cross the number.
            if (veil is not null)
            {
                context.FillRectangle(veil, room, (float)DrawnSizes.VeilRound);
            }

            context.DrawText(text, new(room.X + DrawnSizes.VeilBeside, room.Y));
        }
    }

    // The labels and the room of each, as all is seen now; the texts are made once.
    private List<(FormattedText Text, Rect Room)> Labels()
    {
        var drawing = Drawing!;
        if (_texts is null)
        {
            _texts = [.. drawing.Points.Select(p => Label(p.Label))];
            if ((drawing.ValuesMm is not null ? MapInk : Ink) is { } ink)
            {
                _texts.ForEach(t => t.SetForegroundBrush(ink));
            }
        }

        return [.. drawing.Points.Zip(_texts, (point, text) => (text, To(View, point.At) is var place ? new Rect(place.X - (text.Width / 2), place.Y - text.Height - DrawnSizes.NumberAbove, text.Width, text.Height).Inflate(new Thickness(DrawnSizes.VeilBeside, 0)) : default))];
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
