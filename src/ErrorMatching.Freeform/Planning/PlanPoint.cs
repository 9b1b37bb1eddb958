using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A planned measuring point on the nominal surface.</summary>
/// <param name="Number">Number of the point, from 1, in the order of measuring.</param>
/// <param name="I">Index of the point along its curve (along u), from 0.</param>
/// <param name="J">Index of its curve (along v), from 0.</param>
/// <param name="U">First parameter.</param>
/// <param name="V">Second parameter.</param>
/// <param name="Position">The point on the nominal finished surface, in millimeters.</param>
/// <param name="Normal">Unit normal out of the material.</param>
/// <param name="Reason">The reason for the point.</param>
public sealed record PlanPoint(int Number, int I, int J, double U, double V, Point3 Position, Vector3 Normal, PlanReason Reason);
