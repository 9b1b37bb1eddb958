using ErrorMatching.Freeform;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A surface seen from above, with a value in each cell of its net or with the path of the stylus over it.</summary>
/// <param name="Net">The surface.</param>
/// <param name="ValuesMm">A value at each place of the net; null to show only the surface.</param>
/// <param name="LimitMm">The absolute value of the last color; maps to be compared share it.</param>
/// <param name="Points">Places on it with a label and the text shown on tapping, in the order of measuring.</param>
/// <param name="ShowsWay">True if the path from point to point is drawn.</param>
public sealed record SurfaceDrawing(
    SurfaceNet Net,
    IReadOnlyList<double>? ValuesMm,
    double LimitMm,
    IReadOnlyList<(string Label, Point2 At, string Values)> Points,
    bool ShowsWay)
{
    /// <summary>The areas to draw. They are created with the drawing, off the UI thread if it is.</summary>
    public SurfaceCells Cells { get; } = new(Net, ValuesMm, LimitMm);

    public PlotBox Extent => PlotBox.Of(Net.Places.Select(p => new Point2(p.X, p.Y)));

    /// <summary>Distance between the two nearest points, in units of the drawing; infinite for a single point.</summary>
    public double NearestDistance()
    {
        Point2[] points = [.. Points.Select(p => p.At).OrderBy(p => p.X)];
        var nearest = double.PositiveInfinity;
        for (var i = 0; i < points.Length; i++)
        {
            for (var j = i + 1; j < points.Length && points[j].X - points[i].X < nearest; j++)
            {
                nearest = Math.Min(nearest, (points[j] - points[i]).Length);
            }
        }

        return nearest;
    }
}
