using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A cut along a feature and the displacements of its boundary, from which the feature makes wishes.</summary>
/// <param name="Path">The program, interpreted.</param>
/// <param name="Pass">The cut.</param>
/// <param name="Corrections">The corrections at its key points in the program's frame, in the order of the job.</param>
internal sealed record FeatureCut(NcPath Path, FeaturePass Pass, Vector2[] Corrections)
{
    /// <summary>Its elements in the order of cutting; empty for kinds that are estimated on their own.</summary>
    public IReadOnlyList<BoundaryElement> Elements { get; init; } = [];

    /// <summary>The displacement of each element at a length along the boundary, for the left normal there.</summary>
    public IReadOnlyList<Func<double, Vector2, Vector2>> Courses { get; init; } = [];

    /// <summary>Diameter of the tool that cuts it, mm.</summary>
    public required double ToolDiameterMm { get; init; }
}
