using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A line of a file of measured points, before its point is matched with the plan.</summary>
/// <param name="Number">Number of the point; null if its grid indices are given.</param>
/// <param name="I">Index along its curve; null if only <paramref name="Number"/> is given.</param>
/// <param name="J">Index of its curve; null if only <paramref name="Number"/> is given.</param>
/// <param name="Position">Contact or center, in millimeters.</param>
/// <param name="IsCenter">True for a center, false for a contact.</param>
/// <param name="Line">Line of the file, from 1.</param>
internal sealed record RawPoint(int? Number, int? I, int? J, Point3 Position, bool IsCenter, int Line);
