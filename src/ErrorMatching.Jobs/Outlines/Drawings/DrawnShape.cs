using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>A piece of a drawing in the numbers of its block or model. Each kind stays of its kind under affine maps.</summary>
internal abstract record DrawnShape
{
    /// <summary>Draws it.</summary>
    /// <param name="map">From the block to the drawing in millimeters.</param>
    /// <param name="pen">Receives the curves.</param>
    public abstract void Draw(in PlaneMap map, DrawingPen pen);
}

/// <summary>A line.</summary>
/// <param name="From">Its start.</param>
/// <param name="To">Its end.</param>
internal sealed record SegmentShape(Point2 From, Point2 To) : DrawnShape
{
    /// <inheritdoc/>
    public override void Draw(in PlaneMap map, DrawingPen pen) => pen.Line(map.Of(From), map.Of(To));
}

/// <summary>An arc between two points.</summary>
/// <param name="From">Its start.</param>
/// <param name="To">Its end.</param>
/// <param name="Bulge">The tangent of a quarter of its sweep, positive counterclockwise.</param>
internal sealed record BulgeShape(Point2 From, Point2 To, double Bulge) : DrawnShape
{
    /// <inheritdoc/>
    public override void Draw(in PlaneMap map, DrawingPen pen)
    {
        var (from, to) = (map.Of(From), map.Of(To));
        var chord = to - from;
        if (chord.Length < DrawingLimits.MinMm || Math.Abs(Bulge) * chord.Length / 2 < DrawingLimits.MinMm)
        {
            pen.Line(from, to);
            return;
        }

        if (map.KeepsCircles)
        {
            var (center, radius, start, sweep) = Arc(from, to, map.IsMirror ? -Bulge : Bulge);
            pen.Arc(center, radius, start, sweep);
        }
        else
        {
            var (center, radius, start, sweep) = Arc(From, To, Bulge);
            new EllipseShape(center, new(radius, 0), new(0, radius), start, sweep).Draw(map, pen);
        }
    }

    private static (Point2 Center, double Radius, double Start, double Sweep) Arc(Point2 from, Point2 to, double bulge)
    {
        var chord = to - from;
        var square = bulge * bulge;
        var center = from.Lerp(to, 0.5) + (chord.Left * ((1 - square) / (4 * bulge)));
        var start = from - center;
        return (
            center,
            chord.Length * (1 + square) / (4 * Math.Abs(bulge)),
            Elementary.Atan2(start.Y, start.X),
            4 * Elementary.Atan(bulge));
    }
}

/// <summary>An arc of an ellipse: center + cos t u + sin t v.</summary>
/// <param name="Center">Its center.</param>
/// <param name="U">Half of one diameter.</param>
/// <param name="V">Half of the conjugate diameter.</param>
/// <param name="Start">The parameter of its start, radians.</param>
/// <param name="Sweep">The change of the parameter to its end, radians; two pi for a whole ellipse.</param>
internal sealed record EllipseShape(Point2 Center, Vector2 U, Vector2 V, double Start, double Sweep) : DrawnShape
{
    private const double Whole = Math.Tau - 1e-9;

    /// <inheritdoc/>
    public override void Draw(in PlaneMap map, DrawingPen pen)
    {
        var (center, axes) = (map.Of(Center), new PlaneMap(map.Of(U), map.Of(V), map.Of(Center)));
        if (axes.KeepsCircles)
        {
            var sign = axes.IsMirror ? -1 : 1;
            pen.Arc(center, axes.Scale, axes.Turn + (sign * Start), sign * Sweep);
            return;
        }

        // The image of the unit circle: no chord is farther from it than the largest radius times the chord's height over the circle.
        var largest = Math.Sqrt(axes.X.Dot(axes.X) + axes.Y.Dot(axes.Y));
        var height = Math.Min(0.5, 0.9 * DrawnCourse.ChordMm / largest);
        var step = 2 * Elementary.Acos(1 - height);
        var count = (int)Math.Clamp(Math.Ceiling(Math.Abs(Sweep) / step), 2, DrawingLimits.MaxPoints);
        pen.Reserve(count + 1);
        var points = new Point2[count + 1];
        for (var i = 0; i <= count; i++)
        {
            points[i] = i == count && Math.Abs(Sweep) >= Whole ? points[0] : At(axes, Start + (Sweep * i / count));
        }

        pen.Course(points);
    }

    private static Point2 At(in PlaneMap axes, double t)
    {
        var (sin, cos) = Elementary.SinCos(t);
        return axes.Origin + ((axes.X * cos) + (axes.Y * sin));
    }
}
