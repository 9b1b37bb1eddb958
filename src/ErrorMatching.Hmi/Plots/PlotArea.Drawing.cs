using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <content>Draws lines and dots: only as many points as the screen can resolve, and pixel by pixel if they are still many.</content>
public abstract partial class PlotArea
{
    // Above these numbers, line points and dots are drawn pixel by pixel, which takes a tenth of the time.
    private const int MostLinePoints = 500, MostDots = 300;

    private readonly PixelLayer _layer = new();
    private bool _isLayerUsed;

    /// <summary>Size of a pixel in screen units.</summary>
    protected double Pixel => 1 / (TopLevel.GetTopLevel(this)?.RenderScaling ?? 1);

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
        var seen = new List<Point2>();
        for (var i = 0; i < points.Count; i++)
        {
            if (view.ToScreen(points[i]) is var at
                && at.X >= -radius
                && at.X <= view.Width + radius
                && at.Y >= -radius
                && at.Y <= view.Height + radius)
            {
                seen.Add(at);
            }
        }

        if (seen.Count > MostDots && brush is ISolidColorBrush)
        {
            var (scale, color) = (1 / Pixel, PixelLayer.ColorOf(brush));
            ByPixel(view, canvas =>
            {
                var disk = PixelCanvas.Disk(radius * scale);
                foreach (var at in seen)
                {
                    canvas.Dot((int)(at.X * scale), (int)(at.Y * scale), color, disk);
                }
            });
            return;
        }

        foreach (var at in seen)
        {
            context.DrawEllipse(brush, null, new Point(at.X, at.Y), radius, radius);
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

    private void ShowPixels(DrawingContext context)
    {
        if (_isLayerUsed)
        {
            _layer.Take();
            _layer.Show(context, new Rect(0, 0, _layer.Canvas.Width * Pixel, _layer.Canvas.Height * Pixel));
            _isLayerUsed = false;
        }
    }
}
