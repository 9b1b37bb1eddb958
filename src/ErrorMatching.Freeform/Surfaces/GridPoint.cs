using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A point with its place in a grid.</summary>
/// <param name="I">Number of the point along its curve (along u), from 0 or 1 as the file counts.</param>
/// <param name="J">Number of its curve (along v).</param>
/// <param name="Position">The point in millimetres.</param>
public readonly record struct GridPoint(int I, int J, Point3 Position);
