using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A key point in a drawing of the assembly.</summary>
/// <param name="Label">Its label.</param>
/// <param name="At">Its place on the boundary that is drawn, mm.</param>
/// <param name="Normal">Unit normal of the boundary, from the counterpart's material to its tool: into the part.</param>
/// <param name="Part">How far the part lies from there along the normal, mm.</param>
/// <param name="Before">How far the counterpart lies from there without compensation, mm.</param>
/// <param name="After">How far it lies from there with compensation, mm.</param>
internal sealed record DrawnPoint(string Label, Point2 At, Vector2 Normal, double Part, double Before, double After);
