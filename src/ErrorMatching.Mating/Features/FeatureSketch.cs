using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A sketch of a feature whose position is unknown.</summary>
/// <param name="Points">Its key points in the order of cutting.</param>
/// <param name="Outline">The boundary through them.</param>
/// <param name="WidthMm">Its extent along x.</param>
public sealed record FeatureSketch(IReadOnlyList<Point2> Points, IReadOnlyList<Point2> Outline, double WidthMm);
