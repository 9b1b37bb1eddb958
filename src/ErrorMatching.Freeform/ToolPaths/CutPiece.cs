using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Defines a piece of the path reproducibly: a polyline in the parameters, and how finely it is followed.</summary>
/// <param name="Guide">At least two places, joined by straight lines in (u, v).</param>
/// <param name="Finer">Factor applied to the curvature seen at the ends of a step: 1, or more if that was insufficient.</param>
/// <param name="LongestStep">Longest step, as a share of a smooth section.</param>
internal sealed record CutPiece(IReadOnlyList<Point2> Guide, double Finer, double LongestStep)
{
    /// <summary>True if the tool moves from the last point to the first.</summary>
    public bool Backwards { get; init; }

    /// <summary>The points, if some were raised or the path is short enough; null if they are recalculated from the guide.</summary>
    public IReadOnlyList<Point3>? Centers { get; init; }
}

/// <summary>Pieces of the path that are cut consecutively without leaving the surface.</summary>
/// <param name="Pieces">The pieces in order; each starts where the previous one ends.</param>
/// <param name="LeadIn">From the first center to the place where the tool descends, in millimeters.</param>
/// <param name="LeadOut">From the last center to the place where the tool retracts.</param>
internal sealed record CutChain(IReadOnlyList<CutPiece> Pieces, Vector3 LeadIn, Vector3 LeadOut);
