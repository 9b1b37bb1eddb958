using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A point with its indices in a grid.</summary>
/// <param name="I">Index of the point along its curve (along u), from 0 or 1 as in the file.</param>
/// <param name="J">Index of its curve (along v).</param>
/// <param name="Position">The point in millimeters.</param>
public readonly record struct GridPoint(int I, int J, Point3 Position);
