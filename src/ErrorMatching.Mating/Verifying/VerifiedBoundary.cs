using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The boundary of a verified feature, in the part's frame, for plots and drawings.</summary>
/// <param name="Name">Name of the feature.</param>
/// <param name="Band">The limits of the part's deviation: actual - theoretical along the normal.</param>
/// <param name="Points">Its key points as designed, in the order of cutting.</param>
/// <param name="Outline">The boundary that the nominal program cuts, as a polyline.</param>
public sealed record VerifiedBoundary(
    string Name, ToleranceBand Band, IReadOnlyList<(string Label, Point2 Theoretical)> Points, IReadOnlyList<Point2> Outline)
{
    /// <summary>The limits of a mating error.</summary>
    public ToleranceBand ErrorBand => Band.Opposite();
}
