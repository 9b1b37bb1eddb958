namespace ErrorMatching.Geometry;

/// <summary>A place at which a straight line meets a surface.</summary>
/// <param name="At">The place, with derivatives.</param>
/// <param name="Along">Distance from the line's first point in the line's direction in millimetres, negative behind it.</param>
public readonly record struct SurfaceHit(SurfacePoint At, double Along);
