using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Finds the line or circle that carries an element after its wished displacement.</summary>
internal static class DisplacedCarrier
{
    /// <summary>The carrier after the wished displacement. A line passes through its displaced ends. A circle passes through its
    /// displaced start, middle and end, so an equal displacement along the normals keeps the center. For a full circle, the displaced
    /// start and middle are the ends of a diameter.</summary>
    /// <returns>The displaced carrier; null if the element vanishes or turns inside out.</returns>
    public static Carrier? Of(in NcMotion motion, in ElementWish wish)
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

    private static double Outward(Arc2 arc, double fraction, Vector2 displacement) =>
        displacement.Dot(Vector2.FromDirection(arc.StartAngle + (arc.Sweep * fraction)));
}
