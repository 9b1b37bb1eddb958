using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The tolerance of a surface's profile (ISO 1101): every point of the surface is in a zone of this width, centered on the nominal
/// surface.</summary>
/// <param name="WidthMm">Width of the zone, t. A deviation along the normal may be t / 2 to either side.</param>
/// <param name="Rule">How measured points are accepted near the limits.</param>
/// <param name="IsAligned">True if the zone may move and turn with the piece, as for a tolerance without datums: measured points are
/// aligned by a rigid best fit before they are judged. False if datums fix the zone: points are judged where they were measured.</param>
public sealed record ProfileTolerance(double WidthMm, DecisionRule Rule, bool IsAligned)
{
    /// <summary>The limits of a deviation along the normal.</summary>
    public ToleranceBand Limits => new(-WidthMm / 2, WidthMm / 2);
}
