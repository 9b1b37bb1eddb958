using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A place on the nominal surface that is to be touched.</summary>
/// <param name="Number">Number of the point, from 1, in the order of measuring.</param>
/// <param name="I">Number of the point along its curve (along u), from 0.</param>
/// <param name="J">Number of its curve (along v), from 0.</param>
/// <param name="U">First parameter.</param>
/// <param name="V">Second parameter.</param>
/// <param name="Position">The point on the nominal finished surface, in millimetres.</param>
/// <param name="Normal">Unit normal out of the material.</param>
/// <param name="Reason">Why there is a point here.</param>
public sealed record PlanPoint(int Number, int I, int J, double U, double V, Point3 Position, Vector3 Normal, PlanReason Reason);
