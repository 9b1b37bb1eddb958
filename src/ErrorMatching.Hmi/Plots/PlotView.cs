using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>The visible part of a plot: maps plot units (y up) to screen units (y down).</summary>
/// <param name="ScaleX">Screen units per unit of the first coordinate, above zero.</param>
/// <param name="ScaleY">Screen units per unit of the second coordinate, above zero.</param>
/// <param name="Middle">The plot position at the center of the drawing.</param>
/// <param name="Width">Width of the drawing in screen units.</param>
/// <param name="Height">Height of the drawing in screen units.</param>
public readonly record struct PlotView(double ScaleX, double ScaleY, Point2 Middle, double Width, double Height)
{
    /// <summary>The visible box, in plot units.</summary>
    public PlotBox Seen => new(
        Middle.X - (Width / 2 / ScaleX),
        Middle.Y - (Height / 2 / ScaleY),
        Middle.X + (Width / 2 / ScaleX),
        Middle.Y + (Height / 2 / ScaleY));

    /// <summary>The view that shows a whole box, centered and as large as possible.</summary>
    /// <param name="box">The box to show.</param>
    /// <param name="width">Width of the drawing.</param>
    /// <param name="height">Height of the drawing.</param>
    /// <param name="around">Margin on each side.</param>
    /// <param name="isTrue">True if both directions have the same scale.</param>
    public static PlotView Fit(PlotBox box, double width, double height, double around, bool isTrue)
    {
        box = box.IsEmpty ? new(0, 0, 0, 0) : box;
        var (scaleX, scaleY) = (Scale(width, box.Right - box.Left), Scale(height, box.High - box.Low));
        var same = Math.Min(scaleX, scaleY);
        (scaleX, scaleY) = isTrue ? (same, same) : (scaleX, scaleY);

        // A direction without extent gives no scale; a single point is shown as if it were one unit wide.
        var unit = Math.Max(Math.Min(width, height), 1);
        return new(double.IsFinite(scaleX) ? scaleX : unit, double.IsFinite(scaleY) ? scaleY : unit, box.Middle, width, height);

        double Scale(double room, double extent) =>
            extent > 0 && Math.Max(room - (2 * around), 1) / extent is var scale && double.IsFinite(scale)
                ? scale
                : double.PositiveInfinity;
    }

    /// <summary>The screen position of a plot position, from the upper left corner of the drawing.</summary>
    public Point2 ToScreen(Point2 place) =>
        new((Width / 2) + ((place.X - Middle.X) * ScaleX), (Height / 2) - ((place.Y - Middle.Y) * ScaleY));

    /// <summary>The plot position at a point of the screen.</summary>
    public Point2 ToPlot(Point2 screen) =>
        new(Middle.X + ((screen.X - (Width / 2)) / ScaleX), Middle.Y - ((screen.Y - (Height / 2)) / ScaleY));

    /// <summary>Zooms by a factor; the place under a point of the screen stays there.</summary>
    public PlotView Zoom(double factor, Point2 about) => Zoom(factor, factor, about);

    /// <summary>Zooms with one factor for each direction.</summary>
    public PlotView Zoom(double factorX, double factorY, Point2 about)
    {
        var fixedPlace = ToPlot(about);
        return this with
        {
            ScaleX = ScaleX * factorX,
            ScaleY = ScaleY * factorY,
            Middle = new(fixedPlace.X + ((Middle.X - fixedPlace.X) / factorX), fixedPlace.Y + ((Middle.Y - fixedPlace.Y) / factorY)),
        };
    }

    /// <summary>Pans by a distance in screen units.</summary>
    public PlotView Pan(Vector2 by) => this with { Middle = new(Middle.X - (by.X / ScaleX), Middle.Y + (by.Y / ScaleY)) };
}
