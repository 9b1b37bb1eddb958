using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Media.Immutable;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>What a plot is drawn on: words with their background, and lines and dots, of which only as many points are drawn as the
/// screen can resolve, and pixel by pixel if they are still many.</summary>
[System.Diagnostics.CodeAnalysis.SuppressMessage(
    "Design", "CA1001", Justification = "The layer is let go when the plot leaves the screen.")]
public abstract class PlotPaper : Control
{
    public static readonly StyledProperty<IBrush?> InkProperty = AvaloniaProperty.Register<PlotPaper, IBrush?>(nameof(Ink));

    public static readonly StyledProperty<IBrush?> RuleProperty = AvaloniaProperty.Register<PlotPaper, IBrush?>(nameof(Rule));

    public static readonly StyledProperty<IBrush?> GroundProperty = AvaloniaProperty.Register<PlotPaper, IBrush?>(nameof(Ground));

    public static readonly StyledProperty<double> LabelSizeProperty = AvaloniaProperty.Register<PlotPaper, double>(nameof(LabelSize), 1);

    // Above these numbers, line points and dots are drawn pixel by pixel, which takes a tenth of the time.
    private const int MostLinePoints = 500, MostDots = 300;

    private protected static readonly Typeface Plain = new(FontFamily.Default),
        Strong = new(FontFamily.Default, FontStyle.Normal, FontWeight.SemiBold);

    private readonly HashSet<(string Words, Typeface Typeface)> _words = [];
    private readonly PixelLayer _layer = new();

    // What is drawn pixel by pixel in this drawing, and what the layer shows: mostly the same if only a crosshair has moved.
    private readonly List<(Strokes What, Action<PixelCanvas> Paint)> _wanted = [];
    private readonly List<Strokes> _painted = [];

    static PlotPaper() => AffectsRender<PlotPaper>(InkProperty, RuleProperty, GroundProperty, LabelSizeProperty);

    /// <summary>Color of labels.</summary>
    public IBrush? Ink
    {
        get => GetValue(InkProperty);
        set => SetValue(InkProperty, value);
    }

    /// <summary>Color of rules, frames and the crosshair.</summary>
    public IBrush? Rule
    {
        get => GetValue(RuleProperty);
        set => SetValue(RuleProperty, value);
    }

    /// <summary>Color of the background.</summary>
    public IBrush? Ground
    {
        get => GetValue(GroundProperty);
        set => SetValue(GroundProperty, value);
    }

    public double LabelSize
    {
        get => GetValue(LabelSizeProperty);
        set => SetValue(LabelSizeProperty, value);
    }

    /// <summary>Size of a pixel in screen units.</summary>
    protected double Pixel => 1 / (TopLevel.GetTopLevel(this)?.RenderScaling ?? 1);

    /// <summary>The words drawn since <see cref="Begin"/>, each with its typeface.</summary>
    private protected IEnumerable<(string Words, Typeface Typeface)> WordsDrawn => _words;

    /// <summary>Starts a new drawing.</summary>
    private protected void Begin()
    {
        _words.Clear();
        _wanted.Clear();
    }

    /// <summary>Draws a label where room was found, with its leader line if it is away from its place.</summary>
    private protected void Words(DrawingContext context, FormattedText text, LabelRoom room)
    {
        if (room.Leader is var (from, to))
        {
            context.DrawLine(new Pen(Rule, DrawnSizes.Thin), from, to);
        }

        Words(context, text, room.Corner);
    }

    /// <summary>Draws text on its own background, so that lines do not cross it out.</summary>
    protected void Words(DrawingContext context, FormattedText text, Point at)
    {
        ArgumentNullException.ThrowIfNull(context);
        ArgumentNullException.ThrowIfNull(text);
        if (Ground is ISolidColorBrush ground)
        {
            context.FillRectangle(
                new ImmutableSolidColorBrush(ground.Color, DrawnSizes.VeilOpacity),
                new Rect(at, new Size(text.Width, text.Height)).Inflate(new Thickness(DrawnSizes.VeilBeside, 0)),
                (float)DrawnSizes.VeilRound);
        }

        context.DrawText(text, at);
    }

    /// <summary>Text in the color of the plot's labels.</summary>
    protected FormattedText Label(string text, bool isStrong = false)
    {
        var typeface = isStrong ? Strong : Plain;
        _words.Add((text, typeface));
        return new(text, System.Globalization.CultureInfo.InvariantCulture, FlowDirection.LeftToRight, typeface, LabelSize, Ink);
    }

    /// <summary>Draws a polyline in plot coordinates. A point that is not finite interrupts it.</summary>
    protected void Line(DrawingContext context, Pen pen, IReadOnlyList<Point2> line, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        ArgumentNullException.ThrowIfNull(pen);
        var (scale, thick) = (1 / Pixel, (int)Math.Max(1, Math.Round(pen.Thickness / Pixel)));
        var strokes = new Strokes(line, view, Pixel, PixelLayer.ColorOf(pen.Brush), thick, pen.DashStyle is not null, AreDots: false);
        var points = IsPainted(strokes) ? null : PlotThinning.Of(line, view);
        if (points is null || (points.Count > MostLinePoints && pen.Brush is ISolidColorBrush))
        {
            _wanted.Add((strokes, canvas =>
                canvas.Lines(points ?? PlotThinning.Of(line, view), scale, strokes.Color, thick, strokes.IsDashed)));
            return;
        }

        var geometry = new StreamGeometry();
        using (var figure = geometry.Open())
        {
            for (var i = 0; i < points.Count; i++)
            {
                var at = new Point(points[i].At.X, points[i].At.Y);
                if (points[i].Begins)
                {
                    figure.BeginFigure(at, isFilled: false);
                }
                else
                {
                    figure.LineTo(at);
                }

                if (i + 1 == points.Count || points[i + 1].Begins)
                {
                    figure.EndFigure(isClosed: false);
                }
            }
        }

        if (points.Count > 0)
        {
            context.DrawGeometry(null, pen, geometry);
        }
    }

    /// <summary>Draws a dot at each visible point.</summary>
    protected void Dots(DrawingContext context, IBrush? brush, double radius, IReadOnlyList<Point2> points, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        ArgumentNullException.ThrowIfNull(points);
        bool IsSeen(Point2 at) =>
            at.X >= -radius && at.X <= view.Width + radius && at.Y >= -radius && at.Y <= view.Height + radius;

        var strokes = new Strokes(points, view, Pixel, PixelLayer.ColorOf(brush), radius, IsDashed: false, AreDots: true);
        var seen = IsPainted(strokes) ? int.MaxValue : 0;
        for (var i = 0; i < points.Count && seen <= MostDots; i++)
        {
            seen += IsSeen(view.ToScreen(points[i])) ? 1 : 0;
        }

        if (seen > MostDots && brush is ISolidColorBrush)
        {
            void Paint(PixelCanvas canvas)
            {
                var (scale, disk) = (1 / strokes.Pixel, PixelCanvas.Disk(radius * (1 / strokes.Pixel)));
                for (var i = 0; i < points.Count; i++)
                {
                    if (view.ToScreen(points[i]) is var at && IsSeen(at))
                    {
                        canvas.Dot((int)(at.X * scale), (int)(at.Y * scale), strokes.Color, disk);
                    }
                }
            }

            _wanted.Add((strokes, Paint));
            return;
        }

        for (var i = 0; i < points.Count; i++)
        {
            if (view.ToScreen(points[i]) is var at && IsSeen(at))
            {
                context.DrawEllipse(brush, null, new Point(at.X, at.Y), radius, radius);
            }
        }
    }

    /// <summary>Draws a diamond.</summary>
    /// <param name="context">Where to draw.</param>
    /// <param name="fill">Its fill.</param>
    /// <param name="pen">Its border; null for none.</param>
    /// <param name="at">Its center, in screen units.</param>
    /// <param name="reach">Distance from the center to the corners.</param>
    protected static void Diamond(DrawingContext context, IBrush? fill, Pen? pen, Point at, double reach)
    {
        ArgumentNullException.ThrowIfNull(context);
        var diamond = new StreamGeometry();
        using (var figure = diamond.Open())
        {
            figure.BeginFigure(new(at.X, at.Y - reach), isFilled: true);
            figure.LineTo(new(at.X + reach, at.Y));
            figure.LineTo(new(at.X, at.Y + reach));
            figure.LineTo(new(at.X - reach, at.Y));
            figure.EndFigure(isClosed: true);
        }

        context.DrawGeometry(fill, pen, diamond);
    }

    /// <summary>Shows everything that was drawn pixel by pixel since <see cref="Begin"/>.</summary>
    private protected void ShowPixels(DrawingContext context)
    {
        if (_wanted.Count == 0)
        {
            return;
        }

        var ((_, view, pixel, _, _, _, _), _) = _wanted[0];
        var canvas = _layer.Canvas;
        if (!_wanted.Select(w => w.What).SequenceEqual(_painted))
        {
            canvas.Clear((int)Math.Ceiling(view.Width / pixel), (int)Math.Ceiling(view.Height / pixel));
            _wanted.ForEach(w => w.Paint(canvas));
            _layer.Take();
            _painted.Clear();
            _painted.AddRange(_wanted.Select(w => w.What));
        }

        // One bitmap laid over the rest: drawing even one bitmap is slow without a graphics processor.
        _layer.Show(context, new Rect(0, 0, canvas.Width * pixel, canvas.Height * pixel));
        _wanted.Clear();
    }

    /// <summary>Call this when points that were drawn have changed.</summary>
    private protected void ForgetPixels() => _painted.Clear();

    /// <inheritdoc/>
    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnDetachedFromVisualTree(e);
        _layer.LetGo();
        ForgetPixels();
    }

    // True if the layer shows these strokes at this place of the order.
    private bool IsPainted(Strokes strokes) => _wanted.Count < _painted.Count && _painted[_wanted.Count] == strokes;

    // What the pixels of a line or of dots depend on. The points are the same if they are the same list.
    private readonly record struct Strokes(
        object Points, PlotView View, double Pixel, int Color, double Size, bool IsDashed, bool AreDots);
}
