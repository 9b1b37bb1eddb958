using Avalonia;
using Avalonia.Data;
using Avalonia.Media;
using Avalonia.Media.Immutable;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Draws a surface from above, with colors by value or with the path of the stylus. Tapping a point or a
/// place shows its values.</summary>
internal sealed class SurfacePlot : PlotArea
{
    public static readonly StyledProperty<SurfaceDrawing?> DrawingProperty = AvaloniaProperty.Register<SurfacePlot, SurfaceDrawing?>(
        nameof(Drawing));

    public static readonly StyledProperty<IBrush?> AreaBrushProperty = AvaloniaProperty.Register<SurfacePlot, IBrush?>(nameof(AreaBrush));

    public static readonly StyledProperty<IBrush?> WayBrushProperty = AvaloniaProperty.Register<SurfacePlot, IBrush?>(nameof(WayBrush));

    public static readonly StyledProperty<IBrush?> MapInkProperty = AvaloniaProperty.Register<SurfacePlot, IBrush?>(nameof(MapInk));

    public static readonly StyledProperty<IBrush?> MapPaperProperty = AvaloniaProperty.Register<SurfacePlot, IBrush?>(nameof(MapPaper));

    public static readonly StyledProperty<IBrush?> PathBrushProperty = AvaloniaProperty.Register<SurfacePlot, IBrush?>(nameof(PathBrush));

    public static readonly StyledProperty<SurfacePath?> PathProperty = AvaloniaProperty.Register<SurfacePlot, SurfacePath?>(nameof(Path));

    public static readonly StyledProperty<SurfaceSections?> SectionsProperty = AvaloniaProperty.Register<SurfacePlot, SurfaceSections?>(
        nameof(Sections));

    public static readonly StyledProperty<Point2?> PlaceProperty = AvaloniaProperty.Register<SurfacePlot, Point2?>(
        nameof(Place), defaultBindingMode: BindingMode.TwoWay);

    // Share of the distance between two points: the surface must stay visible between their dots.
    private const double DotShare = 0.15;

    // Share of that distance within which a tap means the point, and not the place beside it.
    private const double TapShare = 0.3;
    private PlotBox _extent = PlotBox.Empty;
    private List<(int Color, StreamGeometry Geometry)>? _shapes;
    private StreamGeometry? _border;
    private List<FormattedText>? _texts;
    private double _nearest = double.PositiveInfinity;

    static SurfacePlot() => AffectsRender<SurfacePlot>(
        AreaBrushProperty,
        WayBrushProperty,
        MapInkProperty,
        MapPaperProperty,
        PathBrushProperty,
        PathProperty,
        SectionsProperty);

    public SurfaceDrawing? Drawing
    {
        get => GetValue(DrawingProperty);
        set => SetValue(DrawingProperty, value);
    }

    /// <summary>Color of the surface if it has no values.</summary>
    public IBrush? AreaBrush
    {
        get => GetValue(AreaBrushProperty);
        set => SetValue(AreaBrushProperty, value);
    }

    /// <summary>Color of the stylus path.</summary>
    public IBrush? WayBrush
    {
        get => GetValue(WayBrushProperty);
        set => SetValue(WayBrushProperty, value);
    }

    /// <summary>Color of text on a map, whose colors are the same in every theme.</summary>
    public IBrush? MapInk
    {
        get => GetValue(MapInkProperty);
        set => SetValue(MapInkProperty, value);
    }

    /// <summary>Background of that text: the color of zero.</summary>
    public IBrush? MapPaper
    {
        get => GetValue(MapPaperProperty);
        set => SetValue(MapPaperProperty, value);
    }

    /// <summary>Color of the path of a tool over the map.</summary>
    public IBrush? PathBrush
    {
        get => GetValue(PathBrushProperty);
        set => SetValue(PathBrushProperty, value);
    }

    /// <summary>The path of a tool over the map; null for none.</summary>
    public SurfacePath? Path
    {
        get => GetValue(PathProperty);
        set => SetValue(PathProperty, value);
    }

    /// <summary>Sections whose lines are drawn over the map; null for none.</summary>
    public SurfaceSections? Sections
    {
        get => GetValue(SectionsProperty);
        set => SetValue(SectionsProperty, value);
    }

    /// <summary>The place whose values are shown; null if none are.</summary>
    public Point2? Place
    {
        get => GetValue(PlaceProperty);
        set => SetValue(PlaceProperty, value);
    }

    /// <summary>True once it was drawn. Shapes are created on demand, because most maps are on tabs that are never opened.</summary>
    internal bool HasShapes => _shapes is not null;

    /// <summary>True if every point shows its number, here and in the twin.</summary>
    internal bool ShowsNumbers => HasRoom && (Twin is not SurfacePlot twin || twin.HasRoom);

    private bool HasRoom => Drawing is null || HaveRoom(Labels(), new Rect(Bounds.Size));

    /// <inheritdoc/>
    protected override PlotBox Extent => _extent;

    /// <inheritdoc/>
    protected override IEnumerable<string> StoredWords => Drawing?.Points.Select(p => p.Label) ?? [];

    /// <inheritdoc/>
    protected override int DatumCount => Drawing?.Points.Count ?? 0;

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == DrawingProperty
            || change.Property == InkProperty
            || change.Property == MapInkProperty
            || change.Property == LabelSizeProperty)
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
        else if (change.Property == ValuesProperty)
        {
            SetCurrentValue(PlaceProperty, Asked?.At);
        }
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumNear(Point2 screen, double reach)
    {
        if (Drawing is not { ValuesMm: { } values } drawing || double.IsInfinity(reach))
        {
            return base.DatumNear(screen, reach);
        }

        // Points that are close together must leave room to tap between them.
        if (base.DatumNear(screen, Math.Min(reach, TapShare * _nearest * View.ScaleX)) is { } point)
        {
            return point;
        }

        var at = View.ToPlot(screen);
        return NetPlaces.Under(drawing.Net, at) is var (u, v)
            ? new(
                at,
                Texts.Current.With(
                    "Freeform.AtPlace",
                    Shown.Number(at.X),
                    Shown.Number(at.Y),
                    Shown.SignedMicrometers(NetPlaces.ValueAt(drawing.Net, values, u, v))),
                base.DatumNear(screen, double.PositiveInfinity)?.Index ?? 0)
            : null;
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumAt(int index) =>
        index >= 0 && Drawing is { } drawing ? new(drawing.Points[index].At, drawing.Points[index].Values, index) : null;

    /// <inheritdoc/>
    protected override void Draw(DrawingContext context, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        var drawing = Drawing!;
        var origin = To(view, Point2.Origin);
        using (context.PushTransform(new Matrix(view.ScaleX, 0, 0, -view.ScaleY, origin.X, origin.Y)))
        {
            // Two neighbors each cover a part of the pixels on their border, and together not all of it: the ground would show through as
            // a seam. So all are filled first with whole pixels, each of which belongs to one of them.
            _shapes ??= ShapesOf(drawing.Cells);
            using (context.PushRenderOptions(new RenderOptions { EdgeMode = EdgeMode.Aliased }))
            {
                Fill(context, _shapes);
            }

            Fill(context, _shapes);

            // The color for zero is the background's, so the surface needs an outline.
            context.DrawGeometry(null, new Pen(Rule, DrawnSizes.Thin / view.ScaleX), _border ??= BorderOf(drawing.Cells));
        }

        Passes(context, view);
        Lines(context, view);
        Way(context, view, drawing);
        Dots(context, view, drawing);
        if (Sections is { } sections)
        {
            Diamond(context, MapPaper, new Pen(MapInk, DrawnSizes.Line), view.At(sections.At), DrawnSizes.Ring);
        }
    }

    private void Passes(DrawingContext context, PlotView view)
    {
        if (Path?.Thinned(view.ScaleX, DrawnSizes.PassesApart) is not var (passes, of))
        {
            return;
        }

        foreach (var pass in passes)
        {
            Line(context, new Pen(PathBrush, DrawnSizes.Thin), pass, view);
        }

        if (of > 1)
        {
            var text = Label(Texts.Current.With("Freeform.PathThinned", Shown.Count(of)));
            text.MaxTextWidth = Math.Max(1, Free.Width - (2 * DrawnSizes.Around));
            Words(context, text, new Point(DrawnSizes.Around, Bounds.Height - text.Height - DrawnSizes.Near));
        }
    }

    // Each line on paper, so that it is seen on every color, with its letter at its end.
    private void Lines(DrawingContext context, PlotView view)
    {
        if (Sections is not { } sections)
        {
            return;
        }

        foreach (var (letter, line, dashes) in new[] {
            ("A", sections.AlongU.Above, null), ("B", sections.AlongV.Above, DrawnSizes.Dashes) })
        {
            Line(context, new Pen(MapPaper, DrawnSizes.Thick), line, view);
            Line(context, new Pen(MapInk, DrawnSizes.Cut, dashes), line, view);
            Letter(context, letter, [.. line.Where(p => p.IsFinite).Select(p => view.At(p))]);
        }
    }

    // At the lower or the right end: the numbers of points are above them.
    private void Letter(DrawingContext context, string letter, IReadOnlyList<Point> line)
    {
        if (line.Count > 1)
        {
            var (end, other) = line[0].X + line[0].Y > line[^1].X + line[^1].Y ? (line[0], line[^1]) : (line[^1], line[0]);
            var (text, way) = (Label(letter, isStrong: true), (Vector)(end - other));
            var at = end + (way / Math.Max(way.Length, 1) * DrawnSizes.LettersAway);
            Words(context, text, at - new Point(text.Width / 2, text.Height / 2));
        }
    }

    /// <summary>Radius of a point's dot, in screen units: small if the points are close together, so as not to hide a small map.</summary>
    internal double DotRadius(PlotView view) => Math.Clamp(DotShare * _nearest * view.ScaleX, DrawnSizes.LeastDot, DrawnSizes.Dot);

    private void Fill(DrawingContext context, List<(int Color, StreamGeometry Geometry)> shapes)
    {
        foreach (var (color, geometry) in shapes)
        {
            context.DrawGeometry(BrushOf(color), null, geometry);
        }
    }

    private IBrush? BrushOf(int color) => color < 0 ? AreaBrush : MapColors.Scale[color];

    private static Point To(PlotView view, Point2 place)
    {
        var (x, y) = view.ToScreen(place);
        return new(x, y);
    }

    // In plot units, one geometry per color: panning and zooming draw the same geometries again.
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
        // Map colors are the same in both themes, and so are the colors of the text on them.
        var isMap = drawing.ValuesMm is not null;
        var radius = DotRadius(view);

        // A ring in the color of paper: in the dark theme, dots on the border would otherwise lose their outer half.
        var ring = isMap && radius > DrawnSizes.MeanMark ? new Pen(MapPaper, DrawnSizes.Thin) : null;
        foreach (var (_, at, _) in drawing.Points)
        {
            context.DrawEllipse(isMap ? MapInk : WayBrush, ring, To(view, at), radius, radius);
        }

        // All numbers or none, here and in the twin: if they overlap, they appear on zooming in. The translucency is in the
        // brush: a group with opacity would need a bitmap for each label.
        if (!ShowsNumbers)
        {
            return;
        }

        var veil = (isMap ? MapPaper : Ground) is ISolidColorBrush paper
            ? new ImmutableSolidColorBrush(paper.Color, isMap ? DrawnSizes.MapVeilOpacity : DrawnSizes.VeilOpacity)
            : null;
        foreach (var (text, room) in Labels())
        {
            // The background shows through; a line there would cross out the number.
            if (veil is not null)
            {
                context.FillRectangle(veil, room, (float)DrawnSizes.VeilRound);
            }

            context.DrawText(text, new(room.X + DrawnSizes.VeilBeside, room.Y));
        }
    }

    // The labels and their rectangles in the current view; the texts are created once.
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

        return [
            .. drawing.Points.Zip(
                _texts,
                (point, text) => (
                    text,
                    To(View, point.At) is var place
                        ? new Rect(
                            place.X - (text.Width / 2),
                            place.Y - text.Height - DrawnSizes.NumberAbove,
                            text.Width,
                            text.Height).Inflate(new Thickness(DrawnSizes.VeilBeside, 0))
                        : default))];
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
