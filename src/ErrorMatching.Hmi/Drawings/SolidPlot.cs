using Avalonia;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Draws a surface in space with its exaggerated error. Dragging and the arrow keys turn it; tapping a point shows its
/// values.</summary>
internal sealed class SolidPlot : PlotArea
{
    public static readonly StyledProperty<SurfaceSolid?> SolidProperty = AvaloniaProperty.Register<SolidPlot, SurfaceSolid?>(nameof(Solid));

    public static readonly StyledProperty<IBrush?> MapInkProperty = AvaloniaProperty.Register<SolidPlot, IBrush?>(nameof(MapInk));

    // Degrees for each unit of the screen: a drag across a station's screen turns the surface once around.
    private const double TurnFactor = 0.4;

    private SurfaceTurn _turn = SurfaceTurn.Default;
    private Point2[] _points = [];

    static SolidPlot() => AffectsRender<SolidPlot>(MapInkProperty);

    public SurfaceSolid? Solid
    {
        get => GetValue(SolidProperty);
        set => SetValue(SolidProperty, value);
    }

    /// <summary>Color of the mesh and the points.</summary>
    public IBrush? MapInk
    {
        get => GetValue(MapInkProperty);
        set => SetValue(MapInkProperty, value);
    }

    /// <summary>How it is turned.</summary>
    internal SurfaceTurn Turn => _turn;

    /// <inheritdoc/>
    protected override PlotBox Extent
    {
        get
        {
            if (Solid is not { } solid)
            {
                return PlotBox.Empty;
            }

            // The same for each yaw, so that it is as large wherever it is turned to.
            var pitch = new SurfaceTurn(0, _turn.PitchDegrees);
            var high = Math.Abs(pitch.Project(new(0, solid.Radius, 0)).At.Y) + Math.Abs(pitch.Project(new(0, 0, solid.HalfHeight)).At.Y);
            return new(-solid.Radius, -high, solid.Radius, high);
        }
    }

    /// <inheritdoc/>
    protected override int DatumCount => Solid?.Drawing.Points.Count ?? 0;

    /// <inheritdoc/>
    public override void Pan(Vector by) => TurnTo(_turn.By(TurnFactor * by.X, TurnFactor * by.Y));

    // A key turns the surface where it points, as a finger does.
    /// <inheritdoc/>
    protected override void Step(Vector by) => Pan(-by);

    /// <inheritdoc/>
    protected override void Reset()
    {
        TurnTo(SurfaceTurn.Default);
        base.Reset();
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == SolidProperty)
        {
            Place();
        }
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumAt(int index) =>
        index >= 0 && index < _points.Length ? new(_points[index], Solid!.Drawing.Points[index].Values, index) : null;

    /// <inheritdoc/>
    protected override void Draw(DrawingContext context, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        var mesh = new Pen(Translucent.Of(MapInk, DrawnSizes.MeshOpacity), DrawnSizes.Thin, lineJoin: PenLineJoin.Bevel);
        foreach (var (facet, corners) in Solid!.Ordered(_turn))
        {
            var geometry = new StreamGeometry();
            using (var figure = geometry.Open())
            {
                figure.BeginFigure(view.At(corners[0]), isFilled: true);
                for (var i = 1; i < corners.Length; i++)
                {
                    figure.LineTo(view.At(corners[i]));
                }

                figure.EndFigure(isClosed: true);
            }

            context.DrawGeometry(facet.Color < 0 ? Ground : MapColors.Scale[facet.Color], mesh, geometry);
        }

        Axes(context);
    }

    private void TurnTo(SurfaceTurn turn)
    {
        if (turn == _turn)
        {
            return;
        }

        _turn = turn;
        Place();
    }

    // The points move with the surface.
    private void Place()
    {
        _points = [.. Solid?.Points.Select(p => _turn.Project(p).At) ?? []];
        Renew(_points);
    }

    // Where x, y and z point to, in the lower left corner.
    private void Axes(DrawingContext context)
    {
        var origin = new Point(2 * DrawnSizes.Axis, Bounds.Height - (2 * DrawnSizes.Axis));
        foreach (var (name, way) in new[] { ("x", new Vector3(1, 0, 0)), ("y", new(0, 1, 0)), ("z", new(0, 0, 1)) })
        {
            var ((x, y), _) = _turn.Project(way);
            var (end, text) = (origin + (new Vector(x, -y) * DrawnSizes.Axis), Label(name));
            context.DrawLine(new Pen(Ink, DrawnSizes.Line), origin, end);
            var beyond = origin + (new Vector(x, -y) * (DrawnSizes.Axis + DrawnSizes.Around));
            Words(context, text, beyond - new Point(text.Width / 2, text.Height / 2));
        }
    }
}
