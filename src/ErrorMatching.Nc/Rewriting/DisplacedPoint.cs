using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>A place on a programmed path and how far the path shall go there.</summary>
/// <param name="Place">The place in the XY plane, mm.</param>
/// <param name="By">The displacement, mm.</param>
public readonly record struct DisplacedPoint(Point2 Place, Vector2 By);
