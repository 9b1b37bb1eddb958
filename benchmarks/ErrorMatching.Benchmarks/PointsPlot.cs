using Avalonia.Media;
using ErrorMatching.Geometry;
using ErrorMatching.Hmi;

namespace ErrorMatching.Benchmarks;

/// <summary>A line through many points with a dot at each, drawn as the station's plots draw.</summary>
internal sealed class PointsPlot(IReadOnlyList<Point2> points) : PlotArea
{
    private const double Thick = 1.5, Dot = 2;
    private readonly PlotBox _extent = PlotBox.Of(points);
    private readonly PlotIndex _index = new(points);

    /// <inheritdoc/>
    protected override PlotBox Extent => _extent;

    /// <inheritdoc/>
    protected override bool IsTrueToScale => false;

    /// <inheritdoc/>
    protected override void Draw(DrawingContext context, PlotView view)
    {
        Line(context, new Pen(Ink, Thick), points, view);
        Dots(context, Ink, Dot, points, view);
    }

    /// <inheritdoc/>
    protected override PlotDatum? DatumNear(Point2 screen, double reach) =>
        _index.Nearest(View.ToPlot(screen), View.ScaleX, View.ScaleY, reach) is var i and >= 0 ? new(points[i], $"{points[i].X} {points[i].Y}", i) : null;
}
