using Avalonia;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Draws a part's features with their points and names.</summary>
internal sealed class PartPlot : PlotArea
{
    public static readonly StyledProperty<PartDrawing?> DrawingProperty = AvaloniaProperty.Register<PartPlot, PartDrawing?>(
        nameof(Drawing));

    public static readonly StyledProperty<IBrush?> PartBrushProperty = AvaloniaProperty.Register<PartPlot, IBrush?>(nameof(PartBrush));

    private const double QuarterShare = 0.25;
    private static readonly double[] NameShares = [0.5, QuarterShare, 1 - QuarterShare];
    private readonly List<string> _leftOut = [];
    private (string Label, Point2 At)[] _points = [];
    private PlotBox _extent = PlotBox.Empty;

    static PartPlot() => AffectsRender<PartPlot>(PartBrushProperty);

    public PartDrawing? Drawing
    {
        get => GetValue(DrawingProperty);
        set => SetValue(DrawingProperty, value);
    }

    /// <summary>Color of lines and points.</summary>
    public IBrush? PartBrush
    {
        get => GetValue(PartBrushProperty);
        set => SetValue(PartBrushProperty, value);
    }

    /// <summary>Labels that found no room in the last drawing.</summary>
    internal IReadOnlyList<string> LeftOut => _leftOut;

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
            _extent = PlotBox.Of(Drawing?.Lines.SelectMany(l => l.Outline) ?? []);
            Renew([.. _points.Select(p => p.At)]);
        }
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumAt(int index) => index < 0 ? null
        : _points[index] is var (label, at) && Drawing!.IsSchematic
            ? new(at, label, index)
            : new(at, $"{label}  x {Shown.Mm(at.X)}  y {Shown.Mm(at.Y)} mm", index);

    /// <inheritdoc/>
    protected override void Draw(DrawingContext context, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        var pen = new Pen(PartBrush, DrawnSizes.Line, Drawing!.IsSchematic ? DrawnSizes.Dashes : null);
        foreach (var line in Drawing.Lines.Where(l => l.Outline.Count > 1))
        {
            Line(context, pen, line.Outline, view);
        }

        var labels = new PlotLabels(
            Drawing.Lines.Select(l => (IReadOnlyList<Point>)[.. l.Outline.Select(p => view.At(p))]),
            [.. _points.Select(p => view.At(p.At))],
            DrawnSizes.Dot,
            Free);
        _leftOut.Clear();
        foreach (var (label, at) in _points)
        {
            Write(context, labels, label, isName: false, view.At(at));
        }

        // Names last: a label belongs next to its dot, but a name fits anywhere along its feature. The middle is tried first.
        foreach (var line in Drawing.Lines.Where(l => l.Outline.Count > 0))
        {
            Write(context, labels, line.Name, isName: true, [.. NameShares.Select(s => view.At(line.At(s)))]);
        }

        // Drawn last, so that no label's background covers them.
        foreach (var (_, at) in _points)
        {
            context.DrawEllipse(PartBrush, null, view.At(at), DrawnSizes.Dot, DrawnSizes.Dot);
        }
    }

    /// <inheritdoc/>
    protected override bool IsDrawnIn(PlotBox box) => Drawing!.Lines.Any(l => box.IsCrossedBy(l.Outline));

    private void Write(DrawingContext context, PlotLabels labels, string words, bool isName, params Point[] places)
    {
        var text = Label(words, isStrong: isName);
        if (places.Select(p => labels.Place(text, p, DrawnSizes.LabelAway, isName)).FirstOrDefault(r => r is not null) is { } room)
        {
            Words(context, text, room);
        }
        else
        {
            _leftOut.Add(words);
        }
    }
}
