using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The exact place of the ball's center where it touches the surface, and how that place moves with the parameters.</summary>
/// <param name="Normal">Unit normal out of the material.</param>
/// <param name="Center">Center of the ball.</param>
/// <param name="Velocity">Derivative of the center along a direction in the parameters.</param>
internal readonly record struct CenterPoint(Vector3 Normal, Point3 Center, Vector3 Velocity);
