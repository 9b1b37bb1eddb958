using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Distance of the counterpart from the part at a key point.</summary>
/// <param name="Vector">Counterpart - part.</param>
/// <param name="Normal">Unit normal of the boundary, from the counterpart's material to its tool.</param>
public readonly record struct MatingError(Vector2 Vector, Vector2 Normal)
{
    /// <summary>Signed length along the normal; positive for an overlap, negative for a gap.</summary>
    public double NormalMm => Vector.Dot(Normal);
}
