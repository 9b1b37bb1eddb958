using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A point in a drawing, with a value.</summary>
/// <param name="Label">Name of the point.</param>
/// <param name="At">Its position.</param>
/// <param name="ValueUm">The value in micrometers.</param>
internal sealed record PlottedPoint(string Label, Point3 At, double ValueUm);
