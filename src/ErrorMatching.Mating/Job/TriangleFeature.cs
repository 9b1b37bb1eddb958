using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A notch or a ridge of two straight flanks.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Selectors of the blocks that cut it.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
/// <param name="FirstFlank">At least two labels on the flank that is cut first, in the order of cutting.</param>
/// <param name="SecondFlank">At least two labels on the other flank, in the order of cutting.</param>
public sealed record TriangleFeature(
    string Name,
    IReadOnlyList<string> Blocks,
    JobTolerance Tolerance,
    CoordinatePlane Plane,
    IReadOnlyList<string> FirstFlank,
    IReadOnlyList<string> SecondFlank)
    : JobFeature(Name, Blocks, Tolerance, Plane)
{
    /// <inheritdoc/>
    public override FeatureKind Kind => FeatureKind.Triangle;

    /// <inheritdoc/>
    public override IReadOnlyList<string> Points => [.. FirstFlank, .. SecondFlank];
}
