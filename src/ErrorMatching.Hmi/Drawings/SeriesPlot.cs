using System.Globalization;
using Avalonia;
using Avalonia.Media;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>Draws values over a series of places, with numbered rules and shaded limits. Tapping a place shows its values.</summary>
internal sealed class SeriesPlot : PlotArea
{
    public static readonly StyledProperty<SeriesDrawing?> DrawingProperty = AvaloniaProperty.Register<SeriesPlot, SeriesDrawing?>(
        nameof(Drawing));

    public static readonly StyledProperty<IBrush?> BeforeBrushProperty = AvaloniaProperty.Register<SeriesPlot, IBrush?>(
        nameof(BeforeBrush));

    public static readonly StyledProperty<IBrush?> AfterBrushProperty = AvaloniaProperty.Register<SeriesPlot, IBrush?>(nameof(AfterBrush));

    public static readonly StyledProperty<IBrush?> BandBrushProperty = AvaloniaProperty.Register<SeriesPlot, IBrush?>(nameof(BandBrush));

    public static readonly StyledProperty<IBrush?> OutsideBrushProperty = AvaloniaProperty.Register<SeriesPlot, IBrush?>(
        nameof(OutsideBrush));

    // A mark is at most half as wide as the distance to the next one.
    private const double MarkShare = 0.25;
    private PlotBox _extent = PlotBox.Empty;
    private string _longest = "";

    static SeriesPlot() => AffectsRender<SeriesPlot>(BeforeBrushProperty, AfterBrushProperty, BandBrushProperty, OutsideBrushProperty);

    public SeriesDrawing? Drawing
    {
        get => GetValue(DrawingProperty);
        set => SetValue(DrawingProperty, value);
    }

    /// <summary>Color of lines without compensation.</summary>
    public IBrush? BeforeBrush
    {
        get => GetValue(BeforeBrushProperty);
        set => SetValue(BeforeBrushProperty, value);
    }

    /// <summary>Color of lines with compensation.</summary>
    public IBrush? AfterBrush
    {
        get => GetValue(AfterBrushProperty);
        set => SetValue(AfterBrushProperty, value);
    }

    /// <summary>Color of the band between limits.</summary>
    public IBrush? BandBrush
    {
        get => GetValue(BandBrushProperty);
        set => SetValue(BandBrushProperty, value);
    }

    /// <summary>Color of the rings around values with compensation that are outside their limits.</summary>
    public IBrush? OutsideBrush
    {
        get => GetValue(OutsideBrushProperty);
        set => SetValue(OutsideBrushProperty, value);
    }

    /// <summary>The area of lines and marks, without numbers, names and buttons.</summary>
    public Rect Inside => new Rect(Bounds.Size).Deflate(Frame + new Thickness(0, 0, ButtonsRoom, 0));

    /// <inheritdoc/>
    protected override PlotBox Extent => _extent;

    /// <inheritdoc/>
    protected override bool IsTrueToScale => false;

    /// <inheritdoc/>
    protected override Thickness Frame =>
        Drawing is { Lines.Count: > 0 } drawing ? new(DrawnSizes.LeftStrip, LegendHeight(drawing), 0, DrawnSizes.BottomStrip) : default;

    /// <inheritdoc/>
    protected override int DatumCount => Drawing?.Labels.Count ?? 0;

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == DrawingProperty)
        {
            _extent = Drawing?.Extent ?? PlotBox.Empty;
            _longest = Drawing?.Labels.MaxBy(l => l.Length) ?? "";
            Renew([]);
        }
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumNear(Point2 screen, double reach)
    {
        // A place is a whole column: the user need not hit the line.
        var index = (int)Math.Round(View.ToPlot(screen).X);
        return index >= 0 && index < DatumCount ? DatumAt(index) : null;
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumAt(int index) => Drawing is { } drawing && index >= 0
        ? new(
            new(index, drawing.Lines.Reverse().Select(l => l.Values[index]).FirstOrDefault(v => v is not null) ?? 0),
            drawing.Values[index],
            index)
        : null;

    /// <inheritdoc/>
    protected override void Draw(DrawingContext context, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        var drawing = Drawing!;
        var inside = Inside;
        using (context.PushClip(inside))
        {
            foreach (var band in drawing.Bands)
            {
                var (low, high) = (To(view, band.First - 0.5, band.Low), To(view, band.Last + 0.5, band.High));
                context.DrawRectangle(BandBrush, null, new Rect(low.X, high.Y, high.X - low.X, low.Y - high.Y));
                context.DrawLine(new Pen(Rule, DrawnSizes.Thin, DrawnSizes.Dashes), low, new(high.X, low.Y));
                context.DrawLine(new Pen(Rule, DrawnSizes.Thin, DrawnSizes.Dashes), new(low.X, high.Y), high);
            }
        }

        Ticks(context, view, inside);
        using (context.PushClip(inside))
        {
            foreach (var line in drawing.Lines)
            {
                Line(context, view, line);
            }

            var reach = MarkSize(view) + DrawnSizes.DiamondMore + DrawnSizes.OutsideMore;
            foreach (var (place, value) in view.ScaleX < DrawnSizes.OutsideApart ? [] : drawing.Outside)
            {
                context.DrawEllipse(null, new Pen(OutsideBrush, DrawnSizes.Line), To(view, place, value), reach, reach);
            }
        }

        Legend(context, drawing);
    }

    /// <inheritdoc/>
    protected override bool IsDrawnIn(PlotBox box) => Drawing!.Lines.Any(l => Pieces(l).Any(p => box.PartOf(p.From, p.To) is not null));

    // Segments between joined neighbors.
    private IEnumerable<(Point2 From, Point2 To)> Pieces(SeriesLine line)
    {
        for (var i = 1; i < line.Values.Count; i++)
        {
            if (!Drawing!.Beginnings.Contains(i)
                && !line.Beginnings.Contains(i)
                && line.Values[i - 1] is { } from
                && line.Values[i] is { } to)
            {
                yield return (new(i - 1, from), new(i, to));
            }
        }
    }

    private static Point To(PlotView view, double index, double value)
    {
        var (x, y) = view.ToScreen(new(index, value));
        return new(x, y);
    }

    private void Ticks(DrawingContext context, PlotView view, Rect inside)
    {
        var step = RoundNumber.AtLeast(DrawnSizes.TicksApart / view.ScaleY);
        var (low, high) = (view.ToPlot(new(0, inside.Bottom)).Y, view.ToPlot(new(0, inside.Top)).Y);
        var (first, last) = (Math.Ceiling(low / step), Math.Floor(high / step));
        var decimals = new string('0', Math.Max(0, (int)Math.Ceiling(-Elementary.Log10(step) - 1e-9)));
        var numbers = new List<(double Value, string Text)> { (0, "0") };
        numbers.AddRange(Drawing!.Bands.SelectMany(b => new[] { b.Low, b.High }).Distinct().Select(l => (l, Number(l, "####"))));

        // The translucency is in the brush: a group with opacity would need a bitmap for each line.
        var (zero, other) = (new Pen(Ink, DrawnSizes.Thin), new Pen(Translucent.Of(Rule, DrawnSizes.RuleOpacity), DrawnSizes.Thin));
        for (var tick = first; tick <= last; tick++)
        {
            var y = To(view, 0, tick * step).Y;
            context.DrawLine(tick == 0 ? zero : other, new(inside.Left, y), new(inside.Right, y));
            numbers.Add((tick * step, Number(tick * step, decimals)));
        }

        Numbers(context, view, inside, numbers.Where(n => n.Value >= low && n.Value <= high));
        context.DrawLine(new Pen(Rule, DrawnSizes.Thin), inside.TopLeft, inside.BottomLeft);
        Places(context, view, inside);
    }

    private string Number(double value, string decimals) =>
        value.ToString(Drawing!.IsMagnitude ? $"0.{decimals}" : $"+0.{decimals};−0.{decimals};0", CultureInfo.InvariantCulture);

    // Zero and limits first, then the numbers between them. A number without room is left out.
    private void Numbers(DrawingContext context, PlotView view, Rect inside, IEnumerable<(double Value, string Text)> numbers)
    {
        var unit = Label(Drawing!.Unit);
        var taken = new List<double>();
        foreach (var (value, words) in numbers)
        {
            var y = To(view, 0, value).Y;
            if (!taken.Exists(t => Math.Abs(t - y) < unit.Height))
            {
                var text = Label(words);
                context.DrawText(text, new(inside.Left - text.Width - DrawnSizes.Near, y - (text.Height / 2)));
                taken.Add(y);
            }
        }

        // Above them, next to the names of the lines.
        context.DrawText(unit, new(inside.Left - unit.Width - DrawnSizes.LabelsApart, DrawnSizes.Near));
    }

    // Every label, or every second, fifth, tenth and so on, as room allows.
    private void Places(DrawingContext context, PlotView view, Rect inside)
    {
        var step = (int)RoundNumber.AtLeast(Math.Max(1, (Label(_longest).Width + DrawnSizes.LabelsApart) / view.ScaleX));
        var (first, last) = (view.ToPlot(new(inside.Left, 0)).X, view.ToPlot(new(inside.Right, 0)).X);
        for (var i = Math.Max(0, (int)Math.Ceiling(first)); i <= Math.Min(Drawing!.Labels.Count - 1, last); i++)
        {
            if ((i + 1) % step == 0)
            {
                var text = Label(Drawing.Labels[i]);
                context.DrawText(text, new(To(view, i, 0).X - (text.Width / 2), inside.Bottom + DrawnSizes.Near));
            }
        }
    }

    private void Line(DrawingContext context, PlotView view, SeriesLine line)
    {
        var pen = PenOf(line.Kind);
        foreach (var (from, to) in Pieces(line))
        {
            context.DrawLine(pen, view.At(from), view.At(to));
        }

        for (var i = 0; i < line.Values.Count; i++)
        {
            if (line.Values[i] is { } value)
            {
                MarkAt(context, line.Kind, To(view, i, value), MarkSize(view), Drawing!.IsHollow.ElementAtOrDefault(i));
            }
        }
    }

    private static double MarkSize(PlotView view) => Math.Clamp(MarkShare * view.ScaleX, DrawnSizes.LeastMark, DrawnSizes.Mark);

    private Pen PenOf(SeriesKind kind) =>
        new Pen(BrushOf(kind), DrawnSizes.Line, kind is SeriesKind.BeforeMean or SeriesKind.AfterMean ? DrawnSizes.Dashes : null);

    private IBrush? BrushOf(SeriesKind kind) => kind is SeriesKind.Before or SeriesKind.BeforeMean ? BeforeBrush : AfterBrush;

    private void MarkAt(DrawingContext context, SeriesKind kind, Point at, double size, bool isHollow)
    {
        var (fill, pen) = (isHollow ? Ground : BrushOf(kind), new Pen(BrushOf(kind), DrawnSizes.Line));
        switch (kind)
        {
            case SeriesKind.Before:
                context.DrawEllipse(fill, pen, at, size, size);
                break;
            case SeriesKind.After:
                Diamond(context, fill, pen, at, size + DrawnSizes.DiamondMore);
                break;
            default:
                context.DrawRectangle(BrushOf(kind), null, new Rect(at, default(Size)).Inflate(DrawnSizes.MeanMark));
                break;
        }
    }

    // Names in rows above the drawing, as many in a row as fit.
    private IEnumerable<(SeriesLine Line, FormattedText Name, Point At)> Named(SeriesDrawing drawing)
    {
        var (x, y) = (DrawnSizes.LeftStrip, DrawnSizes.Near);
        foreach (var line in drawing.Lines)
        {
            var name = Label(line.Name);
            var width = DrawnSizes.LegendMark + DrawnSizes.Around + name.Width;
            if (x > DrawnSizes.LeftStrip && x + width > Bounds.Width - ButtonsRoom)
            {
                (x, y) = (DrawnSizes.LeftStrip, y + name.Height + DrawnSizes.Near);
            }

            yield return (line, name, new(x, y));
            x += width + DrawnSizes.LegendApart;
        }
    }

    private double LegendHeight(SeriesDrawing drawing) => Named(drawing).Max(n => n.At.Y + n.Name.Height) + DrawnSizes.Around;

    private void Legend(DrawingContext context, SeriesDrawing drawing)
    {
        foreach (var (line, name, at) in Named(drawing))
        {
            var middle = at.Y + (name.Height / 2);
            context.DrawLine(PenOf(line.Kind), new(at.X, middle), new(at.X + DrawnSizes.LegendMark, middle));
            MarkAt(context, line.Kind, new(at.X + (DrawnSizes.LegendMark / 2), middle), DrawnSizes.Mark, isHollow: false);
            context.DrawText(name, new(at.X + DrawnSizes.LegendMark + DrawnSizes.Around, at.Y));
        }

        context.DrawLine(new Pen(Rule, DrawnSizes.Thin), Inside.BottomLeft, Inside.BottomRight);
    }
}
