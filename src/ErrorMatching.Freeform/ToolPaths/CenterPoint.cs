using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The exact center of the ball where it touches the surface, and its derivative.</summary>
/// <param name="Normal">Unit normal out of the material.</param>
/// <param name="Center">Center of the ball.</param>
/// <param name="Velocity">Derivative of the center along a direction in the parameters.</param>
internal readonly record struct CenterPoint(Vector3 Normal, Point3 Center, Vector3 Velocity);
