using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The infinite line or full circle that carries a motion in its plane.</summary>
internal readonly record struct Carrier(Line2? Line, Circle2? Circle)
{
    /// <summary>The carrier of a motion before any displacement.</summary>
    public static Carrier Of(in NcMotion motion) => motion.IsArc ? new(null, motion.Arc.Circle) : new(motion.Segment.Line, null);

    /// <summary>The carrier after the wished displacement. A line passes through its displaced ends. A circle passes through its
    /// displaced start, middle and end, so an equal displacement along the normals keeps the center. For a full circle, the displaced
    /// start and middle are the ends of a diameter.</summary>
    /// <returns>The displaced carrier; null if the element vanishes or turns inside out.</returns>
    public static Carrier? Displaced(in NcMotion motion, in ElementWish wish)
    {
        var (start, end) = (motion.PlaneStart + wish.Start, motion.PlaneEnd + wish.End);
        if (!motion.IsArc)
        {
            return (end - start).Dot(motion.PlaneEnd - motion.PlaneStart) > 0 ? new(Line2.Through(start, end), null) : null;
        }

        var arc = motion.Arc;
        var (first, middle, last) = (Outward(arc, 0, wish.Start), Outward(arc, 0.5, wish.Middle), Outward(arc, 1, wish.End));
        if (Math.Max(Math.Abs(first - middle), Math.Abs(last - middle)) < 1e-12)
        {
            return arc.Radius + middle > 0 ? new(null, new(arc.Center, arc.Radius + middle)) : null;
        }

        var throughMiddle = arc.Middle + wish.Middle;
        if (Math.Abs(arc.Sweep.Degrees) > 359.9)
        {
            var diameter = new Segment2(start, throughMiddle);
            return new(null, new(diameter.Middle, diameter.Length / 2));
        }

        try
        {
            var circle = Circle2.Through(start, throughMiddle, end);
            return (circle.Center - arc.Middle).Dot(arc.Center - arc.Middle) > 0 ? new(null, circle) : null;
        }
        catch (GeometryException)
        {
            return null;
        }
    }

    /// <summary>The parallel line or concentric circle through a place.</summary>
    public Carrier Through(Point2 place) => Line is { } line
        ? new(line.Offset(line.SignedDistance(place)), null)
        : new(null, new(Circle!.Value.Center, Circle.Value.Center.DistanceTo(place)));

    /// <summary>The intersection of two carriers that is nearest to a place; null if they do not intersect.</summary>
    public Point2? Meet(Carrier other, Point2 near) => (this, other) switch
    {
        ({ Line: { } a }, { Line: { } b }) => Intersect.Lines(a, b).Nearest(near),
        ({ Line: { } a }, { Circle: { } b }) => Intersect.LineCircle(a, b).Nearest(near),
        ({ Circle: { } a }, { Line: { } b }) => Intersect.LineCircle(b, a).Nearest(near),
        ({ Circle: { } a }, { Circle: { } b }) => Intersect.Circles(a, b).Nearest(near),
        _ => null,
    };

    /// <summary>Unsigned distance of a point.</summary>
    public double Distance(Point2 point) => Math.Abs(Line?.SignedDistance(point) ?? Circle!.Value.SignedDistance(point));

    private static double Outward(Arc2 arc, double fraction, Vector2 displacement) =>
        displacement.Dot(Vector2.FromDirection(arc.StartAngle + (arc.Sweep * fraction)));
}
