using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>What part of a plot is seen, and where on the screen: from the plot's units, upwards, to those of the screen, downwards.</summary>
/// <param name="ScaleX">Units of the screen a unit of the first coordinate, above zero.</param>
/// <param name="ScaleY">The same of the second coordinate.</param>
/// <param name="Middle">The place of the plot in the middle of the drawing.</param>
/// <param name="Width">Width of the drawing in units of the screen.</param>
/// <param name="Height">Its height.</param>
public readonly record struct PlotView(double ScaleX, double ScaleY, Point2 Middle, double Width, double Height)
{
    /// <summary>What is seen, in the plot's units.</summary>
    public PlotBox Seen => new(Middle.X - (Width / 2 / ScaleX), Middle.Y - (Height / 2 / ScaleY), Middle.X + (Width / 2 / ScaleX), Middle.Y + (Height / 2 / ScaleY));

    /// <summary>The view that shows all of a box, in the middle, as large as it can be.</summary>
    /// <param name="box">What is to be seen.</param>
    /// <param name="width">Width of the drawing.</param>
    /// <param name="height">Height of the drawing.</param>
    /// <param name="around">Room on each side that stays free.</param>
    /// <param name="isTrue">True if both directions have the same scale.</param>
    public static PlotView Fit(PlotBox box, double width, double height, double around, bool isTrue)
    {
        box = box.IsEmpty ? new(0, 0, 0, 0) : box;
        var (scaleX, scaleY) = (Scale(width, box.Right - box.Left), Scale(height, box.High - box.Low));
        var same = Math.Min(scaleX, scaleY);
        (scaleX, scaleY) = isTrue ? (same, same) : (scaleX, scaleY);

        // A direction without extent says nothing about its scale; a single place is shown as if it were a unit wide.
        var unit = Math.Max(Math.Min(width, height), 1);
        return new(double.IsFinite(scaleX) ? scaleX : unit, double.IsFinite(scaleY) ? scaleY : unit, box.Middle, width, height);

        double Scale(double room, double extent) => extent > 0 && Math.Max(room - (2 * around), 1) / extent is var scale && double.IsFinite(scale) ? scale : double.PositiveInfinity;
    }

    /// <summary>Where a place is on the screen, from the left upper corner of the drawing.</summary>
    public Point2 ToScreen(Point2 place) => new((Width / 2) + ((place.X - Middle.X) * ScaleX), (Height / 2) - ((place.Y - Middle.Y) * ScaleY));

    /// <summary>What place is at a point of the screen.</summary>
    public Point2 ToPlot(Point2 screen) => new(Middle.X + ((screen.X - (Width / 2)) / ScaleX), Middle.Y - ((screen.Y - (Height / 2)) / ScaleY));

    /// <summary>Nearer or further by a factor; the place under a point of the screen stays under it.</summary>
    public PlotView Zoom(double factor, Point2 about) => Zoom(factor, factor, about);

    /// <summary>The same with a factor for each direction.</summary>
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

    /// <summary>Moves what is seen along with a finger, in units of the screen.</summary>
    public PlotView Pan(Vector2 by) => this with { Middle = new(Middle.X - (by.X / ScaleX), Middle.Y + (by.Y / ScaleY)) };
}
