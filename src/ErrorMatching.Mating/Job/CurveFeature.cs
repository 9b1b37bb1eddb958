using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A hill or a valley.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Selectors of the blocks that cut it.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
/// <param name="Points">At least three labels in the order of cutting.</param>
/// <param name="Degree">Degree of the polynomial; null if it is chosen by leave-one-out error.</param>
/// <param name="Ridge">Weight against overfitting; null if it is chosen by leave-one-out error.</param>
public sealed record CurveFeature(
    string Name,
    IReadOnlyList<string> Blocks,
    JobTolerance Tolerance,
    CoordinatePlane Plane,
    IReadOnlyList<string> Points,
    int? Degree,
    double? Ridge)
    : JobFeature(Name, Blocks, Tolerance, Plane)
{
    /// <inheritdoc/>
    public override FeatureKind Kind => FeatureKind.Curve;

    /// <inheritdoc/>
    public override IReadOnlyList<string> Points { get; } = Points;
}
