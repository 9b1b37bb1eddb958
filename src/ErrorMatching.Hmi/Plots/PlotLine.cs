using Avalonia;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Draws lines and dots of a plot, as few of them as the screen can tell apart.</summary>
public static class PlotLine
{
    /// <summary>Draws a line through points of a plot; one that is no finite number interrupts it.</summary>
    public static void DrawLine(this DrawingContext context, IPen pen, IReadOnlyList<Point2> line, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        var points = PlotThinning.Of(line, view);
        if (points.Count == 0)
        {
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

        context.DrawGeometry(null, pen, geometry);
    }

    /// <summary>Draws a dot at each point of a plot that is seen; of those on one pixel, one.</summary>
    public static void DrawDots(this DrawingContext context, IBrush? brush, double radius, IReadOnlyList<Point2> points, PlotView view)
    {
        ArgumentNullException.ThrowIfNull(context);
        ArgumentNullException.ThrowIfNull(points);
        var drawn = new HashSet<(int, int)>();
        for (var i = 0; i < points.Count; i++)
        {
            var (x, y) = view.ToScreen(points[i]);
            if (x >= -radius && x <= view.Width + radius && y >= -radius && y <= view.Height + radius && drawn.Add(((int)x, (int)y)))
            {
                context.DrawEllipse(brush, null, new Point(x, y), radius, radius);
            }
        }
    }

    /// <summary>Where a place of a plot is drawn.</summary>
    public static Point At(this PlotView view, Point2 place)
    {
        var (x, y) = view.ToScreen(place);
        return new(x, y);
    }
}
