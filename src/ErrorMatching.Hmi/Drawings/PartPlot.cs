using Avalonia;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Draws a part's features with their points and names.</summary>
public sealed class PartPlot : PlotArea
{
    /// <summary>What is drawn.</summary>
    public static readonly StyledProperty<PartDrawing?> DrawingProperty = AvaloniaProperty.Register<PartPlot, PartDrawing?>(nameof(Drawing));

    /// <summary>Lines and points.</summary>
    public static readonly StyledProperty<IBrush?> PartBrushProperty = AvaloniaProperty.Register<PartPlot, IBrush?>(nameof(PartBrush));

    private (string Label, Point2 At)[] _points = [];
    private PlotBox _extent = PlotBox.Empty;

    static PartPlot() => AffectsRender<PartPlot>(PartBrushProperty);

    /// <summary>What is drawn.</summary>
    public PartDrawing? Drawing
    {
        get => GetValue(DrawingProperty);
        set => SetValue(DrawingProperty, value);
    }

    /// <summary>Lines and points.</summary>
    public IBrush? PartBrush
    {
        get => GetValue(PartBrushProperty);
        set => SetValue(PartBrushProperty, value);
    }

    /// <inheritdoc/>
    protected override PlotBox Extent => _extent;

    /// <inheritdoc/>
    protected override int DatumCount => _points.Length;

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == DrawingProperty)
        {
            _points = [.. Drawing?.Lines.SelectMany(l => l.Points) ?? []];
            _extent = PlotBox.Of(_points.Select(p => p.At));
            Renew([.. _points.Select(p => p.At)]);
        }
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumAt(int index) => index < 0 ? null
        : _points[index] is var (label, at) && Drawing!.IsSchematic ? new(at, label, index) : new(at, $"{label}  x {Shown.Mm(at.X)}  y {Shown.Mm(at.Y)} mm", index);

    /// <inheritdoc/>
    protected override void Draw(DrawingContext context, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        var pen = new Pen(PartBrush, DrawnSizes.Line, Drawing!.IsSchematic ? DrawnSizes.Dashes : null);
        foreach (var line in Drawing.Lines.Where(l => l.Points.Count > 0))
        {
            if (line.Points.Count > 1)
            {
                Line(context, pen, [.. line.Points.Select(p => p.At)], view);
            }
        }

        var labels = new PlotLabels(Drawing.Lines.Select(l => (IReadOnlyList<Point>)[.. l.Points.Select(p => view.At(p.At))]), [.. _points.Select(p => view.At(p.At))], DrawnSizes.Dot);
        foreach (var line in Drawing.Lines.Where(l => l.Points.Count > 0))
        {
            Write(context, labels, line.Name, view.At(line.Points[line.Points.Count / 2].At), isName: true);
        }

        foreach (var (label, at) in _points)
        {
            Write(context, labels, label, view.At(at), isName: false);
        }

        // Over the ground of words beside them.
        foreach (var (_, at) in _points)
        {
            context.DrawEllipse(PartBrush, null, view.At(at), DrawnSizes.Dot, DrawnSizes.Dot);
        }
    }

    /// <inheritdoc/>
    protected override bool IsDrawnIn(PlotBox box) => Drawing!.Lines.Any(l => box.IsCrossedBy([.. l.Points.Select(p => p.At)]));

    private void Write(DrawingContext context, PlotLabels labels, string words, Point place, bool isName)
    {
        var text = Label(words, isStrong: isName);
        if (labels.Place(text, place, DrawnSizes.LabelAway, isBelow: isName) is { } room)
        {
            Words(context, text, room);
        }
    }
}
