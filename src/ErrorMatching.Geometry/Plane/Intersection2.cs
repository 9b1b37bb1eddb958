namespace ErrorMatching.Geometry;

/// <summary>How and where two elements of the plane meet.</summary>
/// <param name="Kind">How they meet.</param>
/// <param name="First">The first point along the first element; valid if <paramref name="Count"/> is at least 1.</param>
/// <param name="Second">The second point along the first element; valid if <paramref name="Count"/> is 2.</param>
/// <param name="Count">Number of points: 0, 1 or 2.</param>
public readonly record struct Intersection2(IntersectionKind Kind, Point2 First, Point2 Second, int Count)
{
    /// <summary>No intersection, with the reason as its kind.</summary>
    public static Intersection2 Nowhere(IntersectionKind kind) => new(kind, default, default, 0);

    /// <summary>The point nearest to a place; null if there is none.</summary>
    public Point2? Nearest(Point2 place) => Count switch
    {
        0 => null,
        1 => First,
        _ => place.DistanceTo(First) <= place.DistanceTo(Second) ? First : Second,
    };
}

/// <summary>How two elements meet.</summary>
public enum IntersectionKind
{
    /// <summary>They do not intersect.</summary>
    None,

    /// <summary>They cross in one or two points.</summary>
    Crossing,

    /// <summary>They touch in one point with a common tangent; two arcs of one circle may touch at both ends.</summary>
    Tangent,

    /// <summary>They are parallel lines or concentric circles.</summary>
    Parallel,

    /// <summary>They coincide along a stretch. The points are its ends; none if it is infinite or closed.</summary>
    Coincident,
}
