using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>What was measured of one piece and what was wanted, for other systems.</summary>
/// <param name="Name">The name of the job.</param>
/// <param name="Sha256">SHA-256 of the measurement.</param>
/// <param name="Points">The points, at least one.</param>
public sealed record PieceResult(string Name, string Sha256, IReadOnlyList<PointResult> Points)
{
    /// <summary>The shop's order number; null if there is none.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>True if all points with limits are within them, false if one is not; null if no point has limits.</summary>
    public bool? IsWithinLimits => Points.Any(p => p.IsWithinLimits == false) ? false
        : Points.Any(p => p.IsWithinLimits is not null) ? true
        : null;
}

/// <summary>A measured point.</summary>
/// <param name="Label">Its name.</param>
/// <param name="Nominal">Where it is wanted, in millimeters.</param>
/// <param name="Actual">Where it was measured, in millimeters.</param>
/// <param name="Normal">Unit normal out of the material.</param>
/// <param name="DeviationMm">Deviation along the normal; positive where too much material is left.</param>
public sealed record PointResult(string Label, Point3 Nominal, Point3 Actual, Vector3 Normal, double DeviationMm)
{
    /// <summary>True if the point has a Z; false if it was measured in the plane, and Z is 0.</summary>
    public bool HasZ { get; init; } = true;

    /// <summary>The limits of the deviation; null if it has none.</summary>
    public (double LowerMm, double UpperMm)? Limits { get; init; }

    /// <summary>True if the deviation is within its limits; null if it has none.</summary>
    public bool? IsWithinLimits => Limits is { } limits ? DeviationMm >= limits.LowerMm && DeviationMm <= limits.UpperMm : null;
}
