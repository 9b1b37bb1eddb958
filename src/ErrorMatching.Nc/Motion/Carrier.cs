using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The infinite line or full circle that carries a motion in its plane.</summary>
internal readonly record struct Carrier(Line2? Line, Circle2? Circle)
{
    /// <summary>The carrier of a motion before any displacement.</summary>
    public static Carrier Of(in NcMotion motion) => motion.IsArc ? new(null, motion.Arc.Circle) : new(motion.Segment.Line, null);

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
}
