using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>The position of a draft's key point in its program.</summary>
/// <param name="Feature">Name of its feature.</param>
/// <param name="Label">Its label.</param>
/// <param name="Plane">The plane of its feature.</param>
/// <param name="At">Its position in the program, mm, in the axis order of the plane.</param>
public sealed record DraftPlace(string Feature, string Label, CoordinatePlane Plane, Point2 At);
