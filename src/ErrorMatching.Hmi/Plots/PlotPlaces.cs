using Avalonia;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Places of plots as the drawing says them.</summary>
public static class PlotPlaces
{
    /// <summary>Where a place of a plot is drawn.</summary>
    public static Point At(this PlotView view, Point2 place)
    {
        var (x, y) = view.ToScreen(place);
        return new(x, y);
    }
}
