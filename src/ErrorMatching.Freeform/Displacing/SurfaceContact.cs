using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>How the ball stands to the surface at a programmed point.</summary>
/// <param name="OverMm">How far the ball is from touching, negative where it cuts in, in millimetres.</param>
/// <param name="Move">The compensation at its foot, in millimetres.</param>
internal readonly record struct SurfaceContact(double OverMm, Vector3 Move)
{
    /// <summary>What the programmed point is moved by: nothing, if the ball is further away than its radius.</summary>
    public Vector3 Moved(double radiusMm) => OverMm <= radiusMm ? Move : Vector3.Zero;
}
