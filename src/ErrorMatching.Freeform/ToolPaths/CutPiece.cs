using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>What a piece of the path is made from, again and again alike: a polyline in the parameters, and how finely it is followed.</summary>
/// <param name="Guide">At least two places, joined by straight lines in (u, v).</param>
/// <param name="Finer">By what factor the curve is taken to be more bent than it shows at the ends of a step: 1, or more where that was not enough.</param>
/// <param name="LongestStep">Longest step, as a share of a smooth section.</param>
internal sealed record CutPiece(IReadOnlyList<Point2> Guide, double Finer, double LongestStep)
{
    /// <summary>True if the tool goes from the last point to the first.</summary>
    public bool Backwards { get; init; }

    /// <summary>The points themselves where some had to be raised, or where the path is short enough to keep them; null where they are made again from the guide.</summary>
    public IReadOnlyList<Point3>? Centers { get; init; }
}
