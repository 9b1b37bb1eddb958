using ErrorMatching.Freeform;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A surface seen from above, with a value in each cell of its net, or with the way of the stylus over it.</summary>
/// <param name="Net">The surface.</param>
/// <param name="ValuesMm">A value at each place of the net; null where only the surface itself is shown.</param>
/// <param name="LimitMm">The absolute value that has the last color; maps that are compared share it.</param>
/// <param name="Points">Places on it with a label and what is told under the finger, in the order of measuring.</param>
/// <param name="ShowsWay">True if the way from point to point is drawn.</param>
public sealed record SurfaceDrawing(SurfaceNet Net, IReadOnlyList<double>? ValuesMm, double LimitMm, IReadOnlyList<(string Label, Point2 At, string Values)> Points, bool ShowsWay)
{
    /// <summary>How much there is.</summary>
    public PlotBox Extent => PlotBox.Of(Net.Places.Select(p => new Point2(p.X, p.Y)));
}
