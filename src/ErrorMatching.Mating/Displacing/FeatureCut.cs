using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A cut along a feature and the displacements of its boundary, from which the feature makes wishes.</summary>
/// <param name="Path">The program, interpreted.</param>
/// <param name="Pass">The cut.</param>
/// <param name="Corrections">The corrections at its key points in the program's frame, in the order of the job.</param>
internal sealed record FeatureCut(NcPath Path, FeaturePass Pass, Vector2[] Corrections)
{
    /// <summary>Along the normal, or along the full difference vector of the points.</summary>
    public required CompensationDirection Along { get; init; }

    /// <summary>Standard uncertainty of a measured coordinate, mm.</summary>
    public required double UncertaintyMm { get; init; }

    /// <summary>Diameter of the tool that cuts it, mm.</summary>
    public required double ToolDiameterMm { get; init; }
}
