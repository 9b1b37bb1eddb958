using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The position of the ball relative to the surface at a programmed point.</summary>
/// <param name="OverMm">Gap between ball and surface in millimeters; negative if the ball cuts in.</param>
/// <param name="Move">The compensation at its foot, in millimeters.</param>
internal readonly record struct SurfaceContact(double OverMm, Vector3 Move)
{
    /// <summary>The displacement of the programmed point: zero if the gap is larger than the ball's radius.</summary>
    public Vector3 Moved(double radiusMm) => OverMm <= radiusMm ? Move : Vector3.Zero;
}
