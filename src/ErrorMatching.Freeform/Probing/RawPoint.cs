using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A line of a file of measured points, before it is known whether its point belongs to the plan.</summary>
/// <param name="Number">Number of the point; null where its place in the grid is given.</param>
/// <param name="I">Number along its curve; null where only <paramref name="Number"/> is given.</param>
/// <param name="J">Number of its curve; null likewise.</param>
/// <param name="Position">Contact or center, in millimetres.</param>
/// <param name="IsCenter">True for a center, false for a contact.</param>
/// <param name="Line">Line of the file, from 1.</param>
internal sealed record RawPoint(int? Number, int? I, int? J, Point3 Position, bool IsCenter, int Line);
