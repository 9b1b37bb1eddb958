namespace ErrorMatching.Geometry;

/// <content>Lines with circles; the straight element is always first.</content>
public static partial class Intersect
{
    /// <summary>Intersects a line and a circle: two crossings, one tangency at the foot of the center, or none. A circle of radius zero is
    /// touched, never crossed.</summary>
    /// <param name="a">The line.</param>
    /// <param name="b">The circle.</param>
    /// <param name="tolerance">Maximum difference between center distance and radius for a tangency, in millimeters.</param>
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

        // The product keeps digits near a tangency that a difference of squares would lose.
        var half = Math.Sqrt((b.Radius - distance) * (b.Radius + distance));
        return Two(IntersectionKind.Crossing, a.At(foot - half), a.At(foot + half));
    }

    /// <summary>Intersects a line and an arc.</summary>
    /// <param name="a">The line.</param>
    /// <param name="b">The arc.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 LineCircle(Line2 a, Arc2 b, double tolerance = DefaultTolerance) =>
        Restrict(LineCircle(a, b.Circle, tolerance), Piece.Of(a), Piece.Of(b), tolerance);

    /// <summary>Intersects a segment and a circle.</summary>
    /// <param name="a">The segment. If its length is zero, it is a point, which crosses the circle if it is on it.</param>
    /// <param name="b">The circle.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 LineCircle(Segment2 a, Circle2 b, double tolerance = DefaultTolerance) =>
        a.Length == 0
            ? AtPoint(a.Start, Math.Abs(b.SignedDistance(a.Start)), tolerance)
            : Restrict(LineCircle(a.Line, b, tolerance), Piece.Of(a), Piece.Of(b), tolerance);

    /// <summary>Intersects a segment and an arc.</summary>
    /// <param name="a">The segment. If its length is zero, it is a point, which crosses the arc if it is on it.</param>
    /// <param name="b">The arc.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 LineCircle(Segment2 a, Arc2 b, double tolerance = DefaultTolerance) =>
        a.Length == 0
            ? AtPoint(a.Start, b.DistanceTo(a.Start), tolerance)
            : Restrict(LineCircle(a.Line, b.Circle, tolerance), Piece.Of(a), Piece.Of(b), tolerance);
}
