using Avalonia;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

internal static class PlotPlaces
{
    /// <summary>The screen position of a plot position.</summary>
    public static Point At(this PlotView view, Point2 place)
    {
        var (x, y) = view.ToScreen(place);
        return new(x, y);
    }
}
