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
    private bool _isLayerUsed;

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
    private protected void Begin() => _words.Clear();

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
        var points = PlotThinning.Of(line, view);
        if (points.Count > MostLinePoints && pen.Brush is ISolidColorBrush)
        {
            var (scale, color, thick) = (1 / Pixel, PixelLayer.ColorOf(pen.Brush), (int)Math.Max(1, Math.Round(pen.Thickness / Pixel)));
            ByPixel(view, canvas =>
            {
                for (var i = 1; i < points.Count; i++)
                {
                    if (!points[i].Begins)
                    {
                        var (a, b) = (points[i - 1].At, points[i].At);
                        canvas.Line(a.X * scale, a.Y * scale, b.X * scale, b.Y * scale, color, thick, isDashed: pen.DashStyle is not null);
                    }
                }
            });
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

        var seen = 0;
        for (var i = 0; i < points.Count && seen <= MostDots; i++)
        {
            seen += IsSeen(view.ToScreen(points[i])) ? 1 : 0;
        }

        if (seen > MostDots && brush is ISolidColorBrush)
        {
            var (scale, color) = (1 / Pixel, PixelLayer.ColorOf(brush));
            ByPixel(view, canvas =>
            {
                var disk = PixelCanvas.Disk(radius * scale);
                for (var i = 0; i < points.Count; i++)
                {
                    if (view.ToScreen(points[i]) is var at && IsSeen(at))
                    {
                        canvas.Dot((int)(at.X * scale), (int)(at.Y * scale), color, disk);
                    }
                }
            });
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
        if (_isLayerUsed)
        {
            _layer.Take();
            _layer.Show(context, new Rect(0, 0, _layer.Canvas.Width * Pixel, _layer.Canvas.Height * Pixel));
            _isLayerUsed = false;
        }
    }

    /// <inheritdoc/>
    protected override void OnDetachedFromVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnDetachedFromVisualTree(e);
        _layer.LetGo();
    }

    // All pixel drawing goes into one bitmap laid over the rest: drawing even one bitmap is slow without a graphics processor.
    private void ByPixel(PlotView view, Action<PixelCanvas> paint)
    {
        if (!_isLayerUsed)
        {
            _layer.Canvas.Clear((int)Math.Ceiling(view.Width / Pixel), (int)Math.Ceiling(view.Height / Pixel));
            _isLayerUsed = true;
        }

        paint(_layer.Canvas);
    }
}
