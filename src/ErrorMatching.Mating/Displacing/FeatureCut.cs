using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A cut along a feature and the displacements of its boundary, from which the feature makes wishes.</summary>
/// <param name="Job">The job.</param>
/// <param name="Path">The program, interpreted.</param>
/// <param name="Pass">The cut.</param>
/// <param name="Corrections">The corrections at its key points in the program's frame, in the order of the job.</param>
internal sealed record FeatureCut(MatingJob Job, NcPath Path, FeaturePass Pass, Vector2[] Corrections);
