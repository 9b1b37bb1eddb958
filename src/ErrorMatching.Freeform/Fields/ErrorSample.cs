using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The measured error at one point: the height of the material above the required surface.</summary>
/// <param name="Point">Number of the point in the measuring plan.</param>
/// <param name="I">Number of the point along its curve (along u), from 0.</param>
/// <param name="J">Number of its curve (along v), from 0.</param>
/// <param name="U">First parameter of the foot on the nominal surface.</param>
/// <param name="V">Second parameter of the foot.</param>
/// <param name="Nominal">The foot: the point of the nominal finished surface whose normal passes through the measured point, in mm.</param>
/// <param name="Normal">Unit normal out of the material there.</param>
/// <param name="ErrorMm">Signed distance of the measured point from the surface required by the stage (nominal plus stock), positive out
/// of the material, in millimeters.</param>
public sealed record ErrorSample(int Point, int I, int J, double U, double V, Point3 Nominal, Vector3 Normal, double ErrorMm);
