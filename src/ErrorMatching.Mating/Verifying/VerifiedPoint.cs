using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A key point of the part and of two counterparts, in the part's frame.</summary>
/// <param name="Label">Name of the key point.</param>
/// <param name="Part">Its measured position on the part.</param>
/// <param name="Before">Its measured position on the counterpart cut without compensation.</param>
/// <param name="After">Its measured position on the counterpart cut with compensation.</param>
/// <param name="Normal">Unit normal of the boundary, from the counterpart's material to its tool.</param>
public sealed record VerifiedPoint(string Label, Point2 Part, Point2 Before, Point2 After, Vector2 Normal)
{
    /// <summary>The gap that the job wants there, mm.</summary>
    public double GapMm { get; init; }

    /// <summary>The mating error before: counterpart - part, less the wanted gap.</summary>
    public MatingError BeforeError => new(Before - Part + (Normal * GapMm), Normal);

    /// <summary>The mating error after: counterpart - part, less the wanted gap.</summary>
    public MatingError AfterError => new(After - Part + (Normal * GapMm), Normal);
}

/// <summary>Distance of the counterpart from the part at a key point.</summary>
/// <param name="Vector">Counterpart - part.</param>
/// <param name="Normal">Unit normal of the boundary, from the counterpart's material to its tool.</param>
public readonly record struct MatingError(Vector2 Vector, Vector2 Normal)
{
    /// <summary>Signed length along the normal; positive for an overlap, negative for a gap.</summary>
    public double NormalMm => Vector.Dot(Normal);
}
