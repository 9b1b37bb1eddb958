using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A straight line.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Selectors of the blocks that cut it.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
/// <param name="Points">At least two labels in the order of cutting.</param>
/// <param name="Method">How the line is fitted.</param>
public sealed record LineFeature(string Name, IReadOnlyList<string> Blocks, JobTolerance Tolerance, CoordinatePlane Plane, IReadOnlyList<string> Points, LineMethod Method)
    : JobFeature(Name, Blocks, Tolerance, Plane)
{
    /// <inheritdoc/>
    public override FeatureKind Kind => FeatureKind.Line;

    /// <inheritdoc/>
    public override IReadOnlyList<string> Points { get; } = Points;
}
