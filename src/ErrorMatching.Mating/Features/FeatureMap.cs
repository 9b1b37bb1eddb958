using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A feature mapped onto the counterpart's program: the blocks that cut it, and the feet of its key points.</summary>
/// <param name="Feature">The feature.</param>
/// <param name="Blocks">Its blocks: positions in the program, ascending.</param>
/// <param name="Passes">Its cuts, at least one.</param>
/// <param name="Normals">For each key point, the unit normal from the counterpart's material to its tool, in the part's frame.</param>
public sealed record FeatureMap(
    JobFeature Feature, IReadOnlyList<int> Blocks, IReadOnlyList<FeaturePass> Passes, IReadOnlyList<Vector2> Normals);
