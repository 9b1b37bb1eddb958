namespace ErrorMatching.Geometry;

/// <content>Straight with round; the straight element is always the first.</content>
public static partial class Intersect
{
    /// <summary>Where a line meets a circle: two crossings, one tangency at the foot of the center, or none. A circle of radius zero is touched, never crossed.</summary>
    /// <param name="a">The line.</param>
    /// <param name="b">The circle.</param>
    /// <param name="tolerance">By how much the distance of the center may differ from the radius of a tangent, in millimetres.</param>
    public static Intersection2 LineCircle(Line2 a, Circle2 b, double tolerance = DefaultTolerance)
    {
        var (foot, distance) = (a.Along(b.Center), Math.Abs(a.SignedDistance(b.Center)));
        if (Math.Abs(distance - b.Radius) <= tolerance)
        {
            return One(IntersectionKind.Tangent, a.At(foot));
        }

        if (distance > b.Radius)
        {
            return Intersection2.Nowhere(IntersectionKind.None);
        }

        // The product keeps the digits near a tangency that the difference of squares loses.
        var half = Math.Sqrt((b.Radius - distance) * (b.Radius + distance));
        return Two(IntersectionKind.Crossing, a.At(foot - half), a.At(foot + half));
    }

    /// <summary>Where a line meets an arc.</summary>
    /// <param name="a">The line.</param>
    /// <param name="b">The arc.</param>
    /// <param name="tolerance">What touches, in millimetres.</param>
    public static Intersection2 LineCircle(Line2 a, Arc2 b, double tolerance = DefaultTolerance) =>
        Restrict(LineCircle(a, b.Circle, tolerance), Piece.Of(a), Piece.Of(b), tolerance);

    /// <summary>Where a segment meets a circle.</summary>
    /// <param name="a">The segment. Without length it is a point, which is crossed if it lies on the circle.</param>
    /// <param name="b">The circle.</param>
    /// <param name="tolerance">What touches, in millimetres.</param>
    public static Intersection2 LineCircle(Segment2 a, Circle2 b, double tolerance = DefaultTolerance) =>
        a.Length == 0
            ? AtPoint(a.Start, Math.Abs(b.SignedDistance(a.Start)), tolerance)
            : Restrict(LineCircle(a.Line, b, tolerance), Piece.Of(a), Piece.Of(b), tolerance);

    /// <summary>Where a segment meets an arc.</summary>
    /// <param name="a">The segment. Without length it is a point, which is crossed if it lies on the arc.</param>
    /// <param name="b">The arc.</param>
    /// <param name="tolerance">What touches, in millimetres.</param>
    public static Intersection2 LineCircle(Segment2 a, Arc2 b, double tolerance = DefaultTolerance) =>
        a.Length == 0
            ? AtPoint(a.Start, b.DistanceTo(a.Start), tolerance)
            : Restrict(LineCircle(a.Line, b.Circle, tolerance), Piece.Of(a), Piece.Of(b), tolerance);
}
