using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>A place on a programmed path and the displacement of the path there.</summary>
/// <param name="Place">The place in the XY plane, mm.</param>
/// <param name="By">The displacement, mm.</param>
public readonly record struct DisplacedPoint(Point2 Place, Vector2 By);
