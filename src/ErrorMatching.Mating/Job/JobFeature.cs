using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A feature of the mating boundary: its key points, its limits, and the blocks that cut it.</summary>
/// <param name="Name">Its name, unique in the job.</param>
/// <param name="Blocks">Selectors of the blocks as the job writes them: <c>N100</c>, <c>N110..N130</c> or <c>/regular expression/</c>.</param>
/// <param name="Tolerance">The limits of its deviation.</param>
/// <param name="Plane">The plane that its points are projected to.</param>
public abstract record JobFeature(string Name, IReadOnlyList<string> Blocks, JobTolerance Tolerance, CoordinatePlane Plane)
{
    /// <summary>What shape it is.</summary>
    public abstract FeatureKind Kind { get; }

    /// <summary>The labels of all its key points in the order of cutting, ranges expanded.</summary>
    public abstract IReadOnlyList<string> Points { get; }
}
