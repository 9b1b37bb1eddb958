namespace ErrorMatching.Geometry;

/// <summary>An intersection of a straight line with a surface.</summary>
/// <param name="At">The point, with derivatives.</param>
/// <param name="Along">Distance from the line's first point in its direction, in millimeters; negative in the opposite direction.</param>
public readonly record struct SurfaceHit(SurfacePoint At, double Along);
