namespace ErrorMatching.Geometry;

/// <summary>An infinite straight line with a direction.</summary>
public readonly record struct Line2
{
    /// <summary>Creates a line through a point.</summary>
    /// <param name="origin">A point of the line.</param>
    /// <param name="direction">Nonzero direction.</param>
    /// <exception cref="GeometryException">The direction is zero.</exception>
    public Line2(Point2 origin, Vector2 direction)
    {
        Origin = origin;
        Direction = direction.Normalize();
    }

    /// <summary>A point of the line.</summary>
    public Point2 Origin { get; }

    /// <summary>Unit direction.</summary>
    public Vector2 Direction { get; }

    /// <summary>Unit normal to the left.</summary>
    public Vector2 Normal => Direction.Left;

    /// <summary>The line from one point through another.</summary>
    /// <exception cref="GeometryException">The points coincide (<see cref="GeometryError.CoincidentPoints"/>).</exception>
    public static Line2 Through(Point2 from, Point2 to) => new(from, to - from);

    /// <summary>Position of a point's foot along the line, from <see cref="Origin"/>.</summary>
    public double Along(Point2 point) => (point - Origin).Dot(Direction);

    /// <summary>Signed distance of a point, positive to the left.</summary>
    public double SignedDistance(Point2 point) => (point - Origin).Dot(Normal);

    /// <summary>The point of the line at a position from <see cref="Origin"/>.</summary>
    public Point2 At(double along) => Origin + (Direction * along);

    /// <summary>The nearest point of the line.</summary>
    public Point2 Foot(Point2 point) => At(Along(point));

    /// <summary>The parallel line at a signed distance to the left.</summary>
    public Line2 Offset(double left) => new(Origin + (Normal * left), Direction);
}
