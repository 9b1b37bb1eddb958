using Avalonia.Media;
using ErrorMatching.Geometry;
using ErrorMatching.Hmi;

namespace ErrorMatching.Benchmarks;

/// <summary>A line through many points with a dot at each, drawn like the station's plots.</summary>
internal sealed class PointsPlot(IReadOnlyList<Point2> points) : PlotArea
{
    private const double Thick = 1.5, Dot = 2;
    private readonly PlotBox _extent = PlotBox.Of(points);
    private readonly PlotIndex _index = new(points);

    protected override PlotBox Extent => _extent;

    protected override bool IsTrueToScale => false;

    protected override void Draw(DrawingContext context, PlotView view)
    {
        Line(context, new Pen(Ink, Thick), points, view);
        Dots(context, Ink, Dot, points, view);
    }

    protected override PlotDatum? DatumNear(Point2 screen, double reach) =>
        _index.Nearest(View.ToPlot(screen), View.ScaleX, View.ScaleY, reach) is var i and >= 0
            ? new(points[i], $"{points[i].X} {points[i].Y}", i)
            : null;
}
