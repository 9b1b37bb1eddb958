using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>How far the counterpart is from the part at a key point.</summary>
/// <param name="Vector">Counterpart - part.</param>
/// <param name="Normal">Unit normal of the boundary, from the counterpart's material to its tool.</param>
public readonly record struct MatingError(Vector2 Vector, Vector2 Normal)
{
    /// <summary>Its signed length along the normal: positive where the two overlap, negative where a gap is left.</summary>
    public double NormalMm => Vector.Dot(Normal);
}
