using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A point in a drawing, with a value.</summary>
/// <param name="Label">What the point is called.</param>
/// <param name="At">Where it is.</param>
/// <param name="ValueUm">The value in micrometres.</param>
internal sealed record PlottedPoint(string Label, Point3 At, double ValueUm);
